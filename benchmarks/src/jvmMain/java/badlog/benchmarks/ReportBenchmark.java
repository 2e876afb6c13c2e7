package badlog.benchmarks;

import badlog.files.FolderScan;
import badlog.files.LogFile;
import badlog.report.Find;
import badlog.report.FindTextKt;
import badlog.report.Report;
import badlog.report.ReportTextKt;
import badlog.rules.RulesFile;
import badlog.signals.vocabulary.SignalVocabulary;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import kotlin.Unit;

/**
 * Measures a question and a report over a folder of logs. The first run is without a cache and fills it; the second one uses it.
 */
public final class ReportBenchmark {
    private static final String QUESTION = "min(System/Battery Voltage) < 7";
    private static final int WIDTH = 100;

    private ReportBenchmark() {
    }

    public static void main(String[] arguments) throws IOException {
        List<LogFile> files = FolderScan.Companion.of(Path.of(arguments[0]), () -> Unit.INSTANCE).getFiles();
        long bytes = files.stream().mapToLong(LogFile::getSize).sum();
        System.out.printf(Locale.ROOT, "%d logs, %.2f GB%n", files.size(), bytes / 1e9);
        Path cache = Files.createTempDirectory("badlog-report-benchmark");
        try {
            for (String run : List.of("read", "from the cache")) {
                measure("find, " + run, () -> FindTextKt.findText(
                    new Find(QUESTION, List.of(), cache, null, SignalVocabulary.Companion.getNONE(), null).over(files, ReportBenchmark::ignore, result -> Unit.INSTANCE), WIDTH));
                measure("report, " + run, () -> ReportTextKt.reportText(
                        new Report(RulesFile.Companion.getBUILT_IN().getRules(), List.of(), List.of(), cache, null, null, false, null)
                        .over(files, ReportBenchmark::ignore, (log, hooks) -> Unit.INSTANCE), WIDTH));
            }
        } finally {
            try (var kept = Files.list(cache)) {
                for (Path file : kept.toList()) {
                    System.out.printf(Locale.ROOT, "cache of %d kB%n", Files.size(file) / 1000);
                    Files.delete(file);
                }
            }
            Files.delete(cache);
        }
        System.out.printf("peak memory: %s%n", peakMemory());
    }

    private static void measure(String name, Supplier<String> work) {
        long begin = System.nanoTime();
        String text = work.get();
        System.out.printf(Locale.ROOT, "%s: %.2f s (%d lines)%n", name, (System.nanoTime() - begin) / 1e9, text.lines().count());
    }

    private static Unit ignore(int done, int total) {
        return Unit.INSTANCE;
    }

    private static String peakMemory() throws IOException {
        Path status = Path.of("/proc/self/status");
        if (Files.notExists(status)) {
            return "not known here";
        }
        return Files.readAllLines(status).stream().filter(line -> line.startsWith("VmHWM")).findFirst().orElse("not known here");
    }
}
