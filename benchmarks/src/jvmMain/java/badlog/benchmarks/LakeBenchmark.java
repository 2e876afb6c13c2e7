package badlog.benchmarks;

import badlog.season.lake.Lake;
import badlog.season.sql.LakeDatabase;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import kotlin.Unit;

/**
 * Measures making a lake of many bags, refreshing it without changes, and querying it. Making it is compared with Polars and pandas, which
 * only convert the same rows to Parquet files. Programs are measured as their users would, including the start of Java and Python.
 *
 * <p>Arguments: the program {@code badlog}, the folder to work in, the file for the results, the number of bags, the number of rounds, and
 * a Python with Polars and pandas.
 */
public final class LakeBenchmark {
    private static final int SHORT_ROUNDS = 5;

    private static final String LOWEST =
        "SELECT title, \"System/Battery Voltage\".min AS lowest FROM match_statistics ORDER BY lowest";
    private static final String SCAN = "SELECT log, min(\"System/Battery Voltage\") AS lowest FROM samples GROUP BY log ORDER BY lowest";

    private static final String POLARS = """
        import glob, os, sys, polars
        for path in sorted(glob.glob(sys.argv[1] + "/*.bag")):
            rows = polars.read_csv(path, skip_rows=1)
            rows.write_parquet(os.path.join(sys.argv[2], os.path.basename(path) + ".parquet"), compression="zstd")
        """;
    private static final String PANDAS = """
        import glob, os, sys, pandas
        for path in sorted(glob.glob(sys.argv[1] + "/*.bag")):
            rows = pandas.read_csv(path, skiprows=1)
            rows.to_parquet(os.path.join(sys.argv[2], os.path.basename(path) + ".parquet"), compression="zstd")
        """;

    private final String program;
    private final Path work;
    private final Path bags;
    private final String python;
    private final List<String> lines = new ArrayList<>();

    private LakeBenchmark(String program, Path work, int count, String python) {
        this.program = program;
        this.work = work;
        this.bags = work.resolve("lake-bags-" + count);
        this.python = python;
    }

    public static void main(String[] args) throws Exception {
        int count = Integer.parseInt(args[3]);
        LakeBenchmark benchmark = new LakeBenchmark(args[0], Path.of(args[1]), count, args[5]);
        LakeBags.make(benchmark.bags, count);
        benchmark.lines.add(String.format(Locale.ROOT, "| %,d bags of 7,500 rows and 51 columns, %,d MB | time | memory | files |",
            count, sizeOf(benchmark.bags) / 1_000_000));
        benchmark.lines.add("|---|---|---|---|");
        benchmark.measureMaking(Integer.parseInt(args[4]));
        benchmark.measureAsking();
        Files.write(Path.of(args[2]), benchmark.lines, StandardCharsets.UTF_8);
        benchmark.lines.forEach(System.out::println);
    }

    /** Polars and badlog take turns, because machines are noisy. */
    private void measureMaking(int rounds) throws Exception {
        Best lake = new Best();
        Best polars = new Best();
        Best pandas = new Best();
        boolean hasPython = hasPython();
        for (int round = 0; round < rounds; round++) {
            if (hasPython) {
                polars.add(written("polars", python, "-c", POLARS));
            }
            lake.add(written("lake", program, "lake", bags.toString(), "--out", work.resolve("lake").toString()));
            // Only once, because pandas takes the longest, and ratios are relative to Polars.
            if (hasPython && round == 0) {
                pandas.add(written("pandas", python, "-c", PANDAS));
            }
        }
        add("`badlog lake`: tables, statistics, rules, events", lake, sizeOf(work.resolve("lake")));
        if (hasPython) {
            add("Polars: `read_csv`, `write_parquet(compression='zstd')`", polars, sizeOf(work.resolve("polars")));
            add("pandas: `read_csv`, `to_parquet(compression='zstd')`", pandas, sizeOf(work.resolve("pandas")));
            lines.add(String.format(Locale.ROOT, "| `badlog lake` / Polars | %.2f | | %.3f |",
                lake.seconds / polars.seconds, sizeOf(work.resolve("lake")) / (double) sizeOf(work.resolve("polars"))));
        } else {
            lines.add("| Polars and pandas are not installed | | | |");
        }
        Best again = new Best();
        for (int round = 0; round < SHORT_ROUNDS; round++) {
            again.add(MeasuredRun.of(program, "lake", bags.toString(), "--out", work.resolve("lake").toString()));
        }
        add("`badlog lake` again, with nothing new", again, 0);
    }

    /** Runs {@code command}, which writes into an empty folder of this name. Python gets the folders as arguments. */
    private MeasuredRun written(String name, String... command) throws Exception {
        Path folder = work.resolve(name);
        delete(folder);
        if (name.equals("lake")) {
            return MeasuredRun.of(command);
        }
        Files.createDirectories(folder);
        List<String> whole = new ArrayList<>(List.of(command));
        whole.addAll(List.of(bags.toString(), folder.toString()));
        return MeasuredRun.of(whole.toArray(String[]::new));
    }

    private void measureAsking() throws Exception {
        Path lake = work.resolve("lake");
        Path cache = Files.createDirectories(work.resolve("cache"));
        Map<String, String> environment = Map.of("XDG_CACHE_HOME", cache.toString(), "LOCALAPPDATA", cache.toString());
        // The first one makes the lake in the cache.
        MeasuredRun.of(environment, program, "sql", bags.toString(), LOWEST);
        Best fromLake = new Best();
        Best fromLogs = new Best();
        Best scan = new Best();
        for (int round = 0; round < SHORT_ROUNDS; round++) {
            fromLake.add(MeasuredRun.of(program, "sql", lake.toString(), LOWEST));
            fromLogs.add(MeasuredRun.of(environment, program, "sql", bags.toString(), LOWEST));
            scan.add(MeasuredRun.of(program, "sql", lake.toString(), SCAN));
        }
        add("`badlog sql LAKE`: lowest battery per match, from `match_statistics`", fromLake, 0);
        add("`badlog sql LOGS`: the same from the lake in the cache", fromLogs, 0);
        add("`badlog sql LAKE`: the same by the samples of all files", scan, 0);
        add("the first in one process: open the lake, ask, close", inProcess(lake, LOWEST), 0);
        add("the last in one process", inProcess(lake, SCAN), 0);
    }

    private static Best inProcess(Path lake, String sql) {
        Best best = new Best();
        for (int round = 0; round < SHORT_ROUNDS; round++) {
            long before = System.nanoTime();
            try (LakeDatabase database = LakeDatabase.Companion.open(new Lake(lake), null, false)) {
                database.query(sql, columns -> Unit.INSTANCE, row -> true);
            }
            best.add(new MeasuredRun((System.nanoTime() - before) / 1e9, 0));
        }
        return best;
    }

    private boolean hasPython() throws InterruptedException {
        try {
            return new ProcessBuilder(python, "-c", "import pandas, polars, pyarrow").start().waitFor() == 0;
        } catch (IOException missing) {
            return false;
        }
    }

    private void add(String what, Best best, long size) {
        lines.add(String.format(Locale.ROOT, "| %s | %.2f s | %s | %s |", what, best.seconds,
            best.peakKilobytes > 0 ? best.peakKilobytes / 1000 + " MB" : "", size > 0 ? String.format(Locale.ROOT, "%,d MB", size / 1_000_000) : ""));
    }

    private static long sizeOf(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.mapToLong(MeasuredBags::size).sum();
        }
    }

    private static void delete(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    /** The shortest time of some runs, and the most memory that one of them used. */
    private static final class Best {
        private double seconds = Double.MAX_VALUE;
        private long peakKilobytes;

        private void add(MeasuredRun run) {
            seconds = Math.min(seconds, run.seconds());
            peakKilobytes = Math.max(peakKilobytes, run.peakKilobytes());
        }
    }
}
