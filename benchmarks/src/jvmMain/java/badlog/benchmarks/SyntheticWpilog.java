package badlog.benchmarks;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;

/** A WPILOG like a robot's: mostly numbers at 50 Hz, and some poses, arrays, truth values and texts. It is the same at every call. */
final class SyntheticWpilog {
    private static final int NUMBERS = 60;
    private static final int POSE = NUMBERS + 1;
    private static final int AXES = NUMBERS + 2;
    private static final int ENABLED = NUMBERS + 3;
    private static final int STATE = NUMBERS + 4;
    private static final int MESSAGES = NUMBERS + 5;
    private static final int SCHEMA = NUMBERS + 6;

    private final ByteBuffer buffer = ByteBuffer.allocate(1 << 16).order(ByteOrder.LITTLE_ENDIAN);
    private final OutputStream out;
    private long written;

    private SyntheticWpilog(OutputStream out) {
        this.out = out;
    }

    /** Returns a log of at least {@code size} bytes. */
    static byte[] of(long size) {
        ByteArrayOutputStream log = new ByteArrayOutputStream((int) size + (1 << 16));
        try {
            write(log, size);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return log.toByteArray();
    }

    static void write(OutputStream out, long size) throws IOException {
        SyntheticWpilog log = new SyntheticWpilog(out);
        log.begin();
        SplittableRandom random = new SplittableRandom(1014);
        for (long row = 0; log.written < size; row++) {
            log.loop(row, random);
        }
    }

    private void begin() throws IOException {
        buffer.put("WPILOG".getBytes(StandardCharsets.US_ASCII)).putShort((short) 0x0100).putInt(0);
        flush();
        for (int i = 1; i <= NUMBERS; i++) {
            String type = i % 8 == 0 ? "float" : i % 8 == 1 ? "int64" : "double";
            start(i, "/Bank " + i / 10 + "/Signal " + i, type, "{\"unit\":\"V\"}");
        }
        start(POSE, "/Drive/Pose", "struct:Pose2d", "");
        start(AXES, "DS:joystick0/axes", "float[]", "");
        start(ENABLED, "DS:enabled", "boolean", "");
        start(STATE, "/Arm/State", "string", "");
        start(MESSAGES, "messages", "string", "");
        start(SCHEMA, "/.schema/struct:Pose2d", "structschema", "");
        text(SCHEMA, 0, "double x;double y;double angle");
    }

    private void loop(long row, SplittableRandom random) throws IOException {
        long time = row * 20_000 + random.nextInt(500);
        for (int i = 1; i <= NUMBERS; i++) {
            double value = (1 + i % 7) * Math.sin(row * 0.001 * i) + random.nextDouble() * 0.1;
            if (i % 8 == 0) {
                head(i, 4, time);
                buffer.putFloat((float) value);
            } else {
                head(i, 8, time);
                if (i % 8 == 1) buffer.putLong((long) (value * 1000)); else buffer.putDouble(value);
            }
        }
        head(POSE, 24, time);
        buffer.putDouble(row * 0.01).putDouble(row * 0.02).putDouble(Math.sin(row * 0.01));
        head(AXES, 24, time);
        for (int i = 0; i < 6; i++) buffer.putFloat((float) Math.cos(row * 0.01 * i));
        flush();
        if (row % 50 == 0) {
            head(ENABLED, 1, time);
            buffer.put((byte) (row / 50 % 2));
            text(STATE, time, "state " + row / 50 % 5);
        }
        if (row % 100 == 0) text(MESSAGES, time, "loop " + row + " took a little longer than it should have");
    }

    private void head(int id, int size, long time) {
        int timeSize = Math.max(1, (64 - Long.numberOfLeadingZeros(time) + 7) / 8);
        buffer.put((byte) ((timeSize - 1) << 4)).put((byte) id).put((byte) size);
        for (int i = 0; i < timeSize; i++) buffer.put((byte) (time >>> 8 * i));
    }

    private void text(int id, long time, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        head(id, bytes.length, time);
        buffer.put(bytes);
        flush();
    }

    private void start(int id, String name, String type, String metadata) throws IOException {
        head(0, 5 + 12 + name.length() + type.length() + metadata.length(), 0);
        buffer.put((byte) 0).putInt(id);
        for (String text : new String[] {name, type, metadata}) {
            buffer.putInt(text.length()).put(text.getBytes(StandardCharsets.US_ASCII));
        }
        flush();
    }

    private void flush() throws IOException {
        out.write(buffer.array(), 0, buffer.position());
        written += buffer.position();
        buffer.clear();
    }
}
