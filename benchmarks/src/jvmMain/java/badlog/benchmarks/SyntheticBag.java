package badlog.benchmarks;

import badlog.core.bag.BagHeader;
import badlog.core.bag.BagTopic;
import badlog.core.bag.BagValue;
import badlog.core.bag.RowWriter;
import badlog.core.recording.Value;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** A bag of noisy sines at 50 Hz. It is the same at every call, so that the results of two runs can be compared. */
final class SyntheticBag {
    private static final int SEED = 1014;

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
        write(out, rows, new BagHeader(described, List.of(), Map.of()), SEED);
    }

    /**
     * Writes the bag of match {@code number}, with samples unlike any other match's. Its first topic after the time is the battery's
     * voltage.
     */
    static void writeMatch(OutputStream out, int rows, int topics, int number) throws IOException {
        List<BagTopic> described = new ArrayList<>();
        described.add(new BagTopic("Time", "s", List.of("xaxis", "hide"), Map.of()));
        described.add(new BagTopic("System/Battery Voltage", "V", List.of(), Map.of()));
        for (int i = 2; i < topics; i++) {
            described.add(new BagTopic("Bank " + i / 10 + "/Signal " + i, "A", List.of(), Map.of()));
        }
        List<BagValue> values = List.of(
            value("Event Name", "Event " + number % 10), value("Match Type", "Qualification"), value("Match Number", "" + number),
            value("Start Time", "2025-03-14 10:00:00 UTC"));
        write(out, rows, new BagHeader(described, values, Map.of()), SEED + number);
    }

    private static BagValue value(String name, String text) {
        return new BagValue(new Value(name, text), Map.of());
    }

    private static void write(OutputStream out, int rows, BagHeader header, int seed) throws IOException {
        int topics = header.getTopics().size();
        RowWriter writer = new RowWriter();
        writer.header(header, false);
        SplittableRandom random = new SplittableRandom(seed);
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
