package badlog.benchmarks;

import badlog.core.recording.Recording;
import badlog.formats.wpilog.WpilogParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Measures parsing a WPILOG of 100 MB, unless {@code -Dwpilog=FILE} names another. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgsAppend = {"-Xmx1500m", "-XX:+UseSerialGC"})
public class WpilogBenchmark {
    /** The number of megabytes parsed; JMH shows it as megabytes per second. */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.OPERATIONS)
    public static class Megabytes {
        public double megabytes;
    }

    @Param({"true", "false"})
    public boolean keepSamples;

    private byte[] log;

    @Setup
    public void readLog() throws IOException {
        String file = System.getProperty("wpilog");
        log = file == null ? SyntheticWpilog.of(100_000_000) : Files.readAllBytes(Path.of(file));
    }

    @Benchmark
    public Recording parse(Megabytes counter) {
        WpilogParser parser = new WpilogParser(keepSamples, topic -> true);
        parser.accept(log, 0, log.length);
        counter.megabytes += log.length / 1e6;
        return parser.finish();
    }
}
