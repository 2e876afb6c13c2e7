package badlog.benchmarks;

import badlog.core.analysis.DerivationsKt;
import badlog.core.analysis.Downsampling;
import badlog.core.analysis.PixelColumns;
import badlog.core.analysis.Series;
import badlog.core.analysis.SeriesStatistics;
import badlog.core.analysis.SeriesStatisticsKt;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Measures a zoom, a derivation and statistics on a series of a million samples. The zoom is on a screen 1,600 columns wide. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class AnalysisBenchmark {
    private static final int SAMPLES = 1_000_000;

    private Series series;
    private Downsampling downsampling;
    private final PixelColumns columns = new PixelColumns(1600);
    private double from;

    @Setup
    public void makeSeries() {
        SplittableRandom random = new SplittableRandom(1014);
        double[] x = new double[SAMPLES];
        double[] y = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            x[i] = i * 0.02;
            y[i] = Math.sin(i * 0.001) + random.nextDouble();
        }
        series = new Series(x, y);
        downsampling = new Downsampling(series);
        downsampling.fill(0, x[SAMPLES - 1], columns);
    }

    @Benchmark
    public PixelColumns zoom() {
        from = (from + 7.3) % 5000;
        downsampling.fill(from, from + 15_000, columns);
        return columns;
    }

    @Benchmark
    public Series integral() {
        return DerivationsKt.integral(series, false);
    }

    @Benchmark
    public SeriesStatistics statistics() {
        return SeriesStatisticsKt.statistics(series, 0, 1e9, Double.NaN);
    }
}
