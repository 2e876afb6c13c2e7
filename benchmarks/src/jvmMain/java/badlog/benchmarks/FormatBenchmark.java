package badlog.benchmarks;

import badlog.core.number.FiveDigitFormat;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Measures formatting one number, with badlog's code and with the JDK's, which returns the same text. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class FormatBenchmark {
    private static final int NUMBERS = 1000;

    private final double[] numbers =
        new SplittableRandom(1014).doubles(NUMBERS, -200, 200).toArray();
    private final byte[] buffer = new byte[FiveDigitFormat.MAX_LENGTH];

    @Benchmark
    @OperationsPerInvocation(NUMBERS)
    public int ours() {
        int length = 0;
        for (double number : numbers) {
            length += FiveDigitFormat.INSTANCE.write(number, buffer, 0);
        }
        return length;
    }

    @Benchmark
    @OperationsPerInvocation(NUMBERS)
    public int jdk() {
        int length = 0;
        for (double number : numbers) {
            length += String.format(Locale.ROOT, "%.5g", number).length();
        }
        return length;
    }
}
