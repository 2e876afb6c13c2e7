package badlog.benchmarks;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** The bags for measuring whole programs: a given folder's bags, otherwise three bags of 50 topics, which are made once. */
final class MeasuredBags {
    private static final int[] ROWS = {7_500, 100_000, 1_000_000};

    private MeasuredBags() {
    }

    /** Returns the bags, smallest first; synthetic ones are made in the folder {@code made}. */
    static List<Path> find(String given, Path made) throws IOException {
        if (!given.isEmpty()) {
            try (Stream<Path> files = Files.list(Path.of(given))) {
                return files.filter(Files::isRegularFile).sorted(Comparator.comparing(MeasuredBags::size)).toList();
            }
        }
        Files.createDirectories(made);
        List<Path> bags = new ArrayList<>();
        for (int rows : ROWS) {
            Path bag = made.resolve(rows + "x50.bag");
            if (Files.notExists(bag)) {
                Path partial = made.resolve(rows + ".partial");
                try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(partial), 1 << 20)) {
                    SyntheticBag.write(out, rows, 50);
                }
                Files.move(partial, bag);
            }
            bags.add(bag);
        }
        return bags;
    }

    static long size(Path file) {
        return file.toFile().length();
    }
}
