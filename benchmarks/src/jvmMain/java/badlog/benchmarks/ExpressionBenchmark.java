package badlog.benchmarks;

import badlog.core.analysis.AttributeRegistry;
import badlog.core.analysis.LogView;
import badlog.core.bag.BagParser;
import badlog.expression.Answer;
import badlog.expression.Expression;
import badlog.expression.LogViewSignals;
import badlog.expression.ParsedExpression;
import badlog.expression.signals.Vocabulary;
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

/** Measures the time to answer a question about one match of 7,500 rows of 50 topics, without reading the file. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class ExpressionBenchmark {
    private static final String QUESTION = "min(Signal 1) < 7 && Signal 2 > 3 for 0.5 s";
    private static final String WINDOWS = "max(mean(Signal 1, 1 s) - min(Signal 2, 2 s)) > 7";

    private LogView view;
    private LogViewSignals signals;
    private Expression question;
    private Expression windows;

    @Setup
    public void read() {
        byte[] bag = SyntheticBag.of(7_500, 50);
        BagParser parser = new BagParser();
        parser.accept(bag, 0, bag.length);
        view = LogView.Companion.of(parser.finish(), AttributeRegistry.Companion.getSTANDARD());
        signals = new LogViewSignals(view);
        question = (Expression) Expression.Companion.parse(QUESTION, signals.getVocabulary());
        windows = (Expression) Expression.Companion.parse(WINDOWS, signals.getVocabulary());
    }

    /** Asks the same question about the same match again. */
    @Benchmark
    public Answer answer() {
        return question.answer(signals);
    }

    @Benchmark
    public Answer windowed() {
        return windows.answer(signals);
    }

    /** Asks a question about a match after the same question about another match with the same topics. */
    @Benchmark
    public Answer firstAnswer() {
        LogViewSignals fresh = new LogViewSignals(view);
        if (!fresh.getVocabulary().equals(question.getVocabulary())) throw new IllegalStateException();
        return question.answer(fresh);
    }

    /** Asks the first question about a match with topics of its own. */
    @Benchmark
    public ParsedExpression parse() {
        return Expression.Companion.parse(QUESTION, new Vocabulary(signals.getVocabulary().getSignals()));
    }
}
