package badlog.benchmarks;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** A folder of bags like a season's: matches of two and a half minutes with 51 columns. Some differ, the others are copies. */
final class LakeBags {
    private static final int DIFFERENT = 20;
    private static final int ROWS = 7_500;
    private static final int TOPICS = 51;

    private LakeBags() {
    }

    /** Makes {@code count} bags in {@code folder}, if they do not exist yet. */
    static void make(Path folder, int count) throws IOException {
        Files.createDirectories(folder);
        for (int number = 1; number <= count; number++) {
            Path bag = folder.resolve("q" + number + ".bag");
            if (Files.exists(bag)) {
                continue;
            }
            Path partial = folder.resolve("partial");
            if (number <= DIFFERENT) {
                try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(partial), 1 << 20)) {
                    SyntheticBag.writeMatch(out, ROWS, TOPICS, number);
                }
            } else {
                Files.copy(folder.resolve("q" + ((number - 1) % DIFFERENT + 1) + ".bag"), partial);
            }
            Files.move(partial, bag);
        }
    }
}
