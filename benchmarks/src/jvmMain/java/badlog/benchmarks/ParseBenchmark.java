package badlog.benchmarks;

import badlog.core.bag.BagParser;
import badlog.core.recording.Recording;
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

/** Measures parsing a bag: 20,000 rows of 50 topics, 7 MB, unless {@code -Dbag=FILE} names another. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgsAppend = {"-Xmx1g", "-XX:+UseSerialGC"})
public class ParseBenchmark {
    /** The number of megabytes parsed; JMH shows it as megabytes per second. */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.OPERATIONS)
    public static class Megabytes {
        public double megabytes;
    }

    @Param({"true", "false"})
    public boolean keepSamples;

    private byte[] bag;

    @Setup
    public void readBag() throws IOException {
        String file = System.getProperty("bag");
        bag = file == null ? SyntheticBag.of(20_000, 50) : Files.readAllBytes(Path.of(file));
    }

    @Benchmark
    public Recording parse(Megabytes counter) {
        BagParser parser = new BagParser(bag.length, keepSamples);
        parser.accept(bag, 0, bag.length);
        counter.megabytes += bag.length / 1e6;
        return parser.finish();
    }
}
