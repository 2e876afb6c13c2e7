package badlog.benchmarks;

import badlog.core.recording.NumberSinks;
import badlog.files.ReadOptions;
import badlog.files.ReadRecordingKt;
import badlog.formats.LogFormatsKt;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import kotlin.Unit;

/**
 * Measures the time of reading a file as the window does, on one core and on all. The file is in the disk's cache, and the result is a
 * recording with all samples. If Polars is installed in Python, its {@code read_csv} reads the same rows in turn, because machines are
 * noisy.
 *
 * <p>Arguments: a program, which is not used, the folder to work in, the file for the results, and a folder of bags or nothing.
 */
public final class ReadingBenchmark {
    private static final int ROUNDS = 7;

    private static final String POLARS = """
        import sys, time, polars
        print("ready", flush=True)
        for line in sys.stdin:
            begin = time.perf_counter()
            polars.read_csv(line.strip(), skip_rows=1)
            print(time.perf_counter() - begin, flush=True)
        """;

    private ReadingBenchmark() {
    }

    public static void main(String[] args) throws IOException {
        int cores = Runtime.getRuntime().availableProcessors();
        List<String> lines = new ArrayList<>();
        lines.add("| bag | size | one core | " + cores + " cores | Polars `read_csv`, " + cores + " cores |");
        lines.add("|---|---|---|---|---|");
        Process python = new ProcessBuilder("python3", "-c", POLARS).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        try (BufferedReader answers = python.inputReader(); PrintStream files = new PrintStream(python.getOutputStream(), true)) {
            boolean hasPolars = "ready".equals(answers.readLine());
            for (Path bag : MeasuredBags.find(args.length > 3 ? args[3] : "", Path.of(args[1]).resolve("bags"))) {
                double[] best = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
                for (int round = 0; round < ROUNDS; round++) {
                    best[0] = Math.min(best[0], read(bag, 1));
                    best[1] = Math.min(best[1], read(bag, cores));
                    if (hasPolars) {
                        files.println(bag);
                        best[2] = Math.min(best[2], Double.parseDouble(answers.readLine()));
                    }
                }
                String polars = hasPolars ? String.format(Locale.ROOT, "%.3f s", best[2]) : "not installed";
                lines.add(String.format(Locale.ROOT, "| %s | %.1f MB | %.3f s | %.3f s | %s |",
                    bag.getFileName(), MeasuredBags.size(bag) / 1e6, best[0], best[1], polars));
            }
        } finally {
            python.destroy();
        }
        Files.write(Path.of(args[2]), lines, StandardCharsets.UTF_8);
        lines.forEach(System.out::println);
    }

    private static double read(Path bag, int cores) {
        long begin = System.nanoTime();
        ReadOptions options = new ReadOptions(true, false, NumberSinks.Companion.getRECORDING(), cores, null, null);
        ReadRecordingKt.readRecording(bag, LogFormatsKt.getLOG_FORMATS(), options, (done, total) -> Unit.INSTANCE);
        return (System.nanoTime() - begin) / 1e9;
    }
}
