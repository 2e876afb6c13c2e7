package badlog.benchmarks;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Measures the installed {@code badlog-html} as its user would: the whole process, Java's start included. Each time is listed beside that
 * of {@code gzip -6} for the same bag in the same run, because machines are noisy.
 *
 * <p>Arguments: the program, the folder to work in, the file for the results, and a folder of bags or nothing.
 */
public final class ExporterBenchmark {
    private static final long LARGE = 100_000_000;

    private ExporterBenchmark() {
    }

    public static void main(String[] args) throws Exception {
        Path work = Path.of(args[1]);
        List<String> lines = new ArrayList<>();
        lines.add("| bag | size | export | `gzip -6` | peak memory | page | page / bag |");
        lines.add("|---|---|---|---|---|---|---|");
        for (Path bag : MeasuredBags.find(args.length > 3 ? args[3] : "", work.resolve("bags"))) {
            lines.add(measure(Path.of(args[0]), bag, work));
        }
        Files.write(Path.of(args[2]), lines);
        lines.forEach(System.out::println);
    }

    private static String measure(Path program, Path bag, Path work) throws Exception {
        Path page = work.resolve(bag.getFileName() + ".html");
        int rounds = MeasuredBags.size(bag) > LARGE ? 2 : 5;
        double best = Double.MAX_VALUE;
        double gzip = Double.MAX_VALUE;
        long memory = 0;
        for (int round = 0; round < rounds; round++) {
            MeasuredRun export = MeasuredRun.of(program.toString(), bag.toString(), page.toString());
            best = Math.min(best, export.seconds());
            memory = Math.max(memory, export.peakKilobytes());
            gzip = Math.min(gzip, MeasuredRun.of("gzip", "-6", "-c", bag.toString()).seconds());
        }
        double ratio = MeasuredBags.size(page) / (double) MeasuredBags.size(bag);
        return String.format(Locale.ROOT, "| %s | %.1f MB | %.2f s | %.2f s | %d MB | %.1f MB | %.3f |",
            bag.getFileName(), MeasuredBags.size(bag) / 1e6, best, gzip, memory / 1000, MeasuredBags.size(page) / 1e6, ratio);
    }
}
