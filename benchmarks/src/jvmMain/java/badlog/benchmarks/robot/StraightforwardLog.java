package badlog.benchmarks.robot;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.StringJoiner;
import java.util.function.Supplier;

/**
 * A simple bag logger for comparison, like the original badLog. It formats numbers by {@code String.format}, keeps published values in a
 * map of {@code Optional}s, and joins each row for a buffered writer.
 */
final class StraightforwardLog implements AutoCloseable {
    private static final String NOTHING = "-1.0";

    private final List<Column> columns = new ArrayList<>();
    private final Map<String, Optional<String>> published = new HashMap<>();
    private final BufferedWriter out;

    StraightforwardLog(Path file) throws IOException {
        out = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    }

    void query(String name, Supplier<Double> supplier) {
        columns.add(new Column(name, () -> text(supplier.get())));
    }

    void subscribe(String name) {
        published.put(name, Optional.empty());
        columns.add(new Column(name, () -> published.get(name).orElse(NOTHING)));
    }

    void start() {
        StringJoiner titles = new StringJoiner(",");
        columns.forEach(column -> titles.add(column.name));
        writeLine(titles.toString());
    }

    void publish(String name, double value) {
        if (!published.containsKey(name)) {
            throw new IllegalArgumentException(name);
        }
        published.put(name, Optional.of(text(value)));
    }

    void update() {
        columns.stream().forEach(Column::refresh);
        published.replaceAll((name, value) -> Optional.empty());
    }

    void log() {
        StringJoiner row = new StringJoiner(",");
        columns.stream().map(column -> column.current.orElse(NOTHING)).map(StraightforwardLog::quoted)
            .forEach(row::add);
        writeLine(row.toString());
    }

    @Override
    public void close() throws IOException {
        out.close();
    }

    private void writeLine(String line) {
        try {
            out.write(line + System.lineSeparator());
            out.flush();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String text(Double value) {
        return String.format("%.5g", value);
    }

    private static String quoted(String text) {
        return text.contains(",") ? '"' + text + '"' : text;
    }

    private static final class Column {
        private final String name;
        private final Supplier<String> supplier;
        private Optional<String> current = Optional.empty();

        Column(String name, Supplier<String> supplier) {
            this.name = name;
            this.supplier = supplier;
        }

        void refresh() {
            current = Optional.of(supplier.get());
        }
    }
}
