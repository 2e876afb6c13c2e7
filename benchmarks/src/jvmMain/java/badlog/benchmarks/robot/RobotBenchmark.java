package badlog.benchmarks.robot;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * Measures a robot's loop, compiled and interpreted, its start, and the size of its jars; writes a report. Arguments: the report, the jars
 * that a robot gets, and this program's own classes.
 */
final class RobotBenchmark {
    private static final int STARTS = 15;
    private static final String REFERENCE = "straightforward";
    private static final Map<String, String> TITLES = Map.of(
        "primitive", "primitive suppliers, handles",
        "dropIn", "the original's functions",
        REFERENCE, "straightforward port of the original");

    private RobotBenchmark() {
    }

    public static void main(String[] args) throws RunnerException, IOException, InterruptedException {
        Path report = Path.of(args[0]);
        String compiled = table(measure());
        String interpreted = table(measure("-Xint"));
        long jars = size(args[1]);
        String text = """
            # The robot's logger, measured

            Made by `./gradlew :jvm-robot:benchmark` on %d cores (%s %s, Java %s). Machines are noisy: compare ratios
            within one run, not figures of two. One loop: 10 numbers published, 40 asked for,
            a row of 50 written and flushed.

            ## Compiled
            %s
            ## Interpreted (`-Xint`), as a robot's first loops are
            %s
            The box of `Supplier<Double>` is the program's; a few bytes more are the benchmark's own.

            ## Start
            From `init` to the first row with 50 topics, in a JVM that has loaded nothing of it: %s ms (median of %d).

            ## Size
            The jars that a robot gets: %,d bytes.
            """.formatted(
            Runtime.getRuntime().availableProcessors(), System.getProperty("os.name"), System.getProperty("os.arch"),
            System.getProperty("java.version"), compiled, interpreted,
            coldStart(args[1] + File.pathSeparator + args[2]), STARTS, jars);
        Files.createDirectories(report.getParent());
        Files.writeString(report, text);
        System.out.println(text);
    }

    private static Collection<RunResult> measure(String... jvmOptions) throws RunnerException {
        return new Runner(new OptionsBuilder()
            .include(LoopBenchmark.class.getName())
            .addProfiler(GCProfiler.class)
            .forks(1)
            .warmupIterations(4).warmupTime(TimeValue.seconds(1))
            .measurementIterations(5).measurementTime(TimeValue.seconds(1))
            .jvmArgsAppend(jvmOptions)
            .build()).run();
    }

    private static String table(Collection<RunResult> results) {
        Map<String, RunResult> byName = results.stream()
            .collect(Collectors.toMap(result -> result.getPrimaryResult().getLabel(), Function.identity()));
        double reference = byName.get(REFERENCE).getPrimaryResult().getScore();
        StringBuilder table = new StringBuilder(
            "\n| way | µs per loop | less time | garbage per loop |\n|---|---|---|---|\n");
        for (String name : List.of("primitive", "dropIn", REFERENCE)) {
            RunResult result = byName.get(name);
            double time = result.getPrimaryResult().getScore();
            double garbage = result.getSecondaryResults().entrySet().stream()
                .filter(entry -> entry.getKey().endsWith("gc.alloc.rate.norm")).findFirst().orElseThrow()
                .getValue().getScore();
            table.append(String.format(
                Locale.ROOT, "| %s | %.1f | %.1f× | %.0f B |%n", TITLES.get(name), time, reference / time, garbage));
        }
        return table.toString();
    }

    private static String coldStart(String classpath) throws IOException, InterruptedException {
        Path file = Files.createTempFile("badlog", ".bag");
        List<Double> millis = new ArrayList<>();
        for (int i = 0; i < STARTS; i++) {
            Process process = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:+UseSerialGC",
                "-cp", classpath, ColdStart.class.getName(), file.toString()).redirectErrorStream(true).start();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
            process.waitFor();
            millis.add(Long.parseLong(said) / 1000.0);
        }
        Files.delete(file);
        return String.format(Locale.ROOT, "%.1f", millis.stream().sorted().toList().get(STARTS / 2));
    }

    private static long size(String jars) {
        return Stream.of(jars.split(File.pathSeparator)).map(File::new).mapToLong(File::length).sum();
    }
}
