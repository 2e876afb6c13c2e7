package badlog.benchmarks;

import badlog.bag.BagHeader;
import badlog.bag.BagTopic;
import badlog.bag.RowWriter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** A bag of noisy sines at 50 Hz, the same at every call, so that results of two runs can be compared. */
final class SyntheticBag {
    private SyntheticBag() {
    }

    static byte[] of(int rows, int topics) {
        ByteArrayOutputStream bag = new ByteArrayOutputStream();
        try {
            write(bag, rows, topics);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bag.toByteArray();
    }

    static void write(OutputStream out, int rows, int topics) throws IOException {
        List<BagTopic> described = new ArrayList<>();
        described.add(new BagTopic("Time", "s", List.of("xaxis", "hide"), Map.of()));
        for (int i = 1; i < topics; i++) {
            described.add(new BagTopic("Bank " + i / 10 + "/Signal " + i, "V", List.of(), Map.of()));
        }
        RowWriter writer = new RowWriter();
        writer.header(new BagHeader(described, List.of(), Map.of()), false);
        SplittableRandom random = new SplittableRandom(1014);
        for (int row = 0; row < rows; row++) {
            writer.number(row * 0.02);
            for (int i = 1; i < topics; i++) {
                writer.number((1 + i % 7) * Math.sin(row * 0.001 * i) + i + random.nextDouble() * 0.1);
            }
            writer.endRow();
            out.write(writer.getBytes(), 0, writer.getSize());
            writer.clear();
        }
    }
}
