package badlog.benchmarks.robot;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Measures a robot's loop on one core with and without two downloads from its server, and writes a report. It alternates between both, so
 * that other load on the machine affects both. Arguments: the report, the class path of a robot.
 */
final class DownloadBenchmark {
    private static final int TURNS = 8;
    private static final int LOG_BYTES = 30_000_000;

    private DownloadBenchmark() {
    }

    public static void main(String[] args) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("badlog-served");
        Path logs = Files.createDirectory(folder.resolve("logs"));
        Files.write(logs.resolve("match.bag"), new byte[LOG_BYTES]);
        int port;
        try (ServerSocket free = new ServerSocket(0)) {
            port = free.getLocalPort();
        }
        List<Double> without = new ArrayList<>();
        List<Double> beside = new ArrayList<>();
        Process robot = pinned(0, args[1], ServingRobot.class, logs.toString(), Integer.toString(port));
        try (BufferedReader answers = robot.inputReader()) {
            answers.readLine();
            for (int turn = 0; turn < TURNS; turn++) {
                List<Double> alone = loops(robot, answers);
                Process downloads = pinned(1, args[1], Downloads.class, "http://127.0.0.1:" + port + "/logs/match.bag");
                // Both downloads are running.
                BufferedReader begun = downloads.inputReader();
                String first = begun.readLine();
                String second = begun.readLine();
                if (!"begun".equals(first) || !"begun".equals(second)) {
                    throw new IllegalStateException("The downloads did not begin: " + first + ", " + second);
                }
                List<Double> served = loops(robot, answers);
                downloads.destroy();
                downloads.waitFor();
                // The first turn is a warm-up for the compiler.
                if (turn > 0) {
                    without.addAll(alone);
                    beside.addAll(served);
                }
            }
        } finally {
            robot.destroy();
            robot.waitFor();
            try (var files = Files.walk(folder)) {
                files.sorted((a, b) -> b.compareTo(a)).forEach(DownloadBenchmark::delete);
            }
        }
        String text = report(without, beside);
        Files.writeString(Path.of(args[0]), text);
        System.out.println(text);
    }

    private static String report(List<Double> without, List<Double> beside) {
        StringBuilder rows = new StringBuilder();
        for (double part : new double[] {0.5, 0.9, 0.99, 0.999}) {
            double alone = percentile(without, part);
            double served = percentile(beside, part);
            rows.append(String.format(Locale.ROOT, "| %.1f %% | %.3f ms | %.3f ms | %+.3f ms |%n", part * 100, alone, served, served - alone));
        }
        return """
            # A robot's loop beside a download, measured

            Made by `./gradlew :benchmarks:served` on one of %d cores (%s %s, Java %s, `-XX:+UseSerialGC -Xmx64m`). **This is not a roboRIO**, whose
            cores are many times slower: what it shows is that the downloads leave the core to the loop, not how long they would take there.

            A robot is pinned to one core (`taskset -c 0`), and so are all threads of its [server](web.md); it comes before the machine's other programs
            (`nice -n -19`), but its loop does not come before its server. Every 20 ms it does 2 ms of work of its own and logs
            a row of 50 numbers. Two downloads, whose other ends are on another core, take the 1 MB/s that all downloads have together. Each loop counts from the
            moment when it was due to the moment when its row was written. %,d loops without and %,d beside downloads, in turns of 500: what
            else the machine does is in both columns, and is most of what is above 2.2 ms.

            | of all loops | without | beside two downloads | difference |
            |---|---|---|---|
            %s
            """.formatted(
            Runtime.getRuntime().availableProcessors(), System.getProperty("os.name"), System.getProperty("os.arch"),
            System.getProperty("java.version"), without.size(), beside.size(), rows.toString().strip());
    }

    private static double percentile(List<Double> millis, double part) {
        return millis.stream().sorted().toList().get((int) Math.min(millis.size() - 1, Math.ceil(millis.size() * part)));
    }

    private static List<Double> loops(Process robot, BufferedReader answers) throws IOException {
        robot.getOutputStream().write('\n');
        robot.getOutputStream().flush();
        List<Double> millis = new ArrayList<>();
        for (String nanos : answers.readLine().strip().split(" ")) {
            millis.add(Long.parseLong(nanos) / 1e6);
        }
        return millis;
    }

    /** Starts a program with a robot's garbage collector on one core. Its priority is higher if this user may set it. */
    private static Process pinned(int core, String classpath, Class<?> program, String... args) throws IOException {
        List<String> command = new ArrayList<>(List.of(
            "nice", "-n", "-19", "taskset", "-c", Integer.toString(core), Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:+UseSerialGC", "-Xmx64m", "-cp", classpath, program.getName()));
        command.addAll(List.of(args));
        return new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    }

    private static void delete(Path path) {
        try {
            Files.delete(path);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
