package badlog.expression

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.expression.samples.Column
import badlog.expression.samples.Scalar
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.syntax.Function
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.math.abs
import kotlin.random.Random

private const val ROWS = 80
private const val STEP = 0.02

/** The same signals, logged in each row and logged only when they change. */
private class EitherWay(random: Random) {
    private val x = DoubleArray(ROWS) { it * STEP }
    private val samples = mapOf(
        Signal("A", SignalKind.NUMBER) to held(random) { random.nextInt(-2, 4).toDouble() },
        Signal("C", SignalKind.NUMBER) to held(random, longest = 2) { random.nextInt(100) / 8.0 },
        Signal("F", SignalKind.CONDITION) to held(random) { random.nextInt(2).toDouble() },
        Signal("S", SignalKind.STATE) to held(random) { random.nextInt(3).toDouble() },
    )
    private val event = Signal("E", SignalKind.EVENT) to (x.indices.filter { random.nextInt(12) == 0 }).let { kept ->
        Series(DoubleArray(kept.size) { x[kept[it]] }, DoubleArray(kept.size) { random.nextInt(2).toDouble() })
    }
    private val texts = mapOf("S" to listOf("a", "b", "c"), "E" to listOf("xy", "no"))
    private val enabled = listOf(EnabledSpan(Span(0.1, 0.5), true), EnabledSpan(Span(0.5, 1.2), false))

    val inRows = SampleSignals(samples.mapValues { Series(x, it.value) } + event, texts, enabled, rows = x)
    val changes = SampleSignals(samples.mapValues { changesOf(it.value) } + event, texts, enabled, range = inRows.range)

    private fun held(random: Random, longest: Int = 12, value: () -> Double): DoubleArray {
        val y = DoubleArray(ROWS)
        var row = 0
        while (row < ROWS) {
            val next = if (random.nextInt(6) == 0) Double.NaN else value()
            repeat(random.nextInt(1, longest + 1)) { if (row < ROWS) y[row++] = next }
        }
        return y
    }

    private fun changesOf(y: DoubleArray): Series {
        val kept = y.indices.filter { it == 0 || y[it].compareTo(y[it - 1]) != 0 }
        return Series(DoubleArray(kept.size) { x[kept[it]] }, DoubleArray(kept.size) { y[kept[it]] })
    }
}

private val NUMBERS = listOf(
    "A", "C", "abs(A)", "(A + C)", "(A when F)", "if(F, A, C)", "previous(A)", "hold(A)", "derivative(C)", "shift(A, 0.1 s)", "shift(C, -0.2 s)",
    "clamp(C, 2, 9)", "(A when S == 'b')", "(C when enabled)", "(C when during(0.3, 0.9))", "if(F, 1, 0)", "(C ^ 2 - A)",
)
private val CONDITIONS = listOf(
    "F", "A > 1", "not F", "S == 'a'", "S != previous(S)", "(F and A > 0)", "(F or C > 6)", "(A > 0 for 0.1 s)", "(not F for 0.06 s)", "missing(A)",
    "after(F, 0.1 s)", "before(F, 0.1 s)", "first(F, 0.1 s)", "last(F, 0.1 s)", "A > 0 within 0.1 s after changed(S)", "teleop and F", "C > A", "shift(F, 0.14 s)", "hold(E) == 'xy'", "A == previous(A)",
)
private val MOMENTS = listOf("changed(A)", "changed(S)", "changed(F)", "delta(C) > 1", "E contains 'x'", "changed(A) and F", "E == 'xy' or changed(S)", "rises(F)", "falls(A > 0)", "crosses(C, 5)")
private val OF_MOMENTS = listOf("delta(A)", "delta(C)", "delta(A when F)", "delta(if(F, 1, 0))", "lengths(F)", "cycle_times(F)", "number(E)", "(C when changed(S))")

/** All functions of numbers, conditions and moments, except those that count samples. */
private val QUESTIONS = NUMBERS.flatMap { x ->
    listOf(
        "min", "max", "mean", "median", "stddev", "first", "last", "integral", "duration", "time_of_min", "time_of_max",
    ).map { "$it($x)" } + "slope($x, A)" + "correlation(C, $x)" + "percentile($x, 5)" + "percentile($x, 95)" + x
} + CONDITIONS.flatMap { c -> listOf("count", "total", "any", "all", "duration").map { "$it($c)" } + c } +
    MOMENTS.flatMap { m -> listOf("count", "any", "all", "duration").map { "$it($m)" } + m } +
    OF_MOMENTS.flatMap { m -> listOf("min", "max", "mean", "median", "stddev", "first", "last", "count", "sample_mean").map { "$it($m)" } }

private val FOLLOWING_TIME = NUMBERS.flatMap { x -> listOf("mean($x, 0.3 s)", "area($x)") }
private val WINDOWS = NUMBERS.flatMap { x -> listOf("min($x, 0.3 s)", "max($x, 0.1 s)") }

class LoggedEitherWaySpec : FunSpec({
    fun Expression.column(signals: SampleSignals) = Evaluation(signals, root.id + 1).valueOf(root) as Column

    fun Column.at(time: Double) = x.indexOfLast { it <= time + 1e-9 }.let { if (it < 0) Double.NaN else y[it] }

    fun isSame(one: Double, other: Double) = (one.isNaN() && other.isNaN()) || one == other || abs(one - other) <= 1e-9 * maxOf(1.0, abs(one))

    test("the same signal has the same answers, logged in each row or only when it changes") {
        repeat(60) { seed ->
            val logs = EitherWay(Random(seed))
            for (question in QUESTIONS) {
                val expression = parsed(question, logs.inRows.vocabulary)
                fun failed(rows: Any?, changes: Any?): Nothing = throw AssertionError("seed $seed: $question is $rows in rows, $changes of changes")
                val rows = Evaluation(logs.inRows, expression.root.id + 1).valueOf(expression.root)
                val changes = Evaluation(logs.changes, expression.root.id + 1).valueOf(expression.root)
                if (rows is Scalar && changes is Scalar) {
                    if (!isSame(rows.value, changes.value) || !isSame(rows.time, changes.time)) failed(rows.value to rows.time, changes.value to changes.time)
                } else if (rows is Column && changes is Column) {
                    val times = (rows.x + changes.x).filter { it <= logs.inRows.range!!.to }
                    for (time in times) if (!isSame(rows.at(time), changes.at(time))) failed("${rows.at(time)} at $time", changes.at(time))
                }
                val answers = listOf(expression.answer(logs.inRows), expression.answer(logs.changes))
                if (answers[0].outcome != answers[1].outcome || answers[0].spans != answers[1].spans) failed(answers[0], answers[1])
                val areSame = answers[0].quantities.zip(answers[1].quantities).all { (a, b) -> isSame(a.value, b.value) && isSame(a.time, b.time) }
                if (!areSame || answers[0].quantities.size != answers[1].quantities.size) failed(answers[0], answers[1])
            }
        }
    }

    test("functions of time while a value holds agree within a row") {
        repeat(60) { seed ->
            val logs = EitherWay(Random(seed))
            for (question in FOLLOWING_TIME + WINDOWS) {
                val expression = parsed(question, logs.inRows.vocabulary)
                val rows = expression.column(logs.inRows)
                val changes = expression.column(logs.changes)
                for (row in 1 until ROWS - 1) {
                    // A value that ends between two rows is a gap in one of them.
                    val near = (row - 1..row + 1).map { rows.at(it * STEP) }
                    val own = changes.at(row * STEP)
                    val isNear = if (own.isNaN()) near.any { it.isNaN() } else near.any { it.isNaN() } || own in near.min() - 1e-6..near.max() + 1e-6
                    if (!isNear) throw AssertionError("seed $seed: $question is $near around row $row, $own of changes")
                }
            }
        }
    }

    test("a log of changes has the same changes and energy as its rows") {
        val x = DoubleArray(100) { it * 0.1 }
        val rows = SampleSignals(
            mapOf(
                Signal("Gear", SignalKind.STATE) to Series(x, DoubleArray(100) { if (it in 20 until 60) 1.0 else 0.0 }),
                Signal("Current", SignalKind.NUMBER) to Series(x, DoubleArray(100) { if (it < 50) 10.0 else 30.0 }),
            ),
            texts = mapOf("Gear" to listOf("LOW", "HIGH")),
            rows = x,
        )
        val changes = SampleSignals(
            mapOf(
                Signal("Gear", SignalKind.STATE) to Series(doubleArrayOf(0.0, 2.0, 6.0), doubleArrayOf(0.0, 1.0, 0.0)),
                Signal("Current", SignalKind.NUMBER) to Series(doubleArrayOf(0.0, 5.0), doubleArrayOf(10.0, 30.0)),
            ),
            texts = mapOf("Gear" to listOf("LOW", "HIGH")),
            range = Span(0.0, 9.9),
        )
        for ((question, wanted) in listOf("count(changed(Gear))" to "2", "integral(Current)" to "197", "mean(Current)" to "19.899", "median(Current)" to "10")) {
            for (signals in listOf(rows, changes)) {
                readable(parsed(question, signals.vocabulary).answer(signals).quantities[0].value) shouldBe wanted
            }
        }
        errorOf("total(changed(Gear))", rows.vocabulary).message shouldBe
            "A moment has no duration; count(c) counts moments, and hold(x) keeps the text of an event until the next."
    }

    test("the questions include every function except those that count samples") {
        val asked = (QUESTIONS + FOLLOWING_TIME + WINDOWS).joinToString()
        val left = Function.entries.map { it.title }.distinct().filter { "$it(" !in asked }
        left shouldBe listOf(
            "sample_median", "sample_percentile", "sample_stddev", "atan2", "sign", "sqrt", "exp", "log", "log10", "sin", "cos", "tan",
            "asin", "acos", "atan", "floor", "ceil", "round",
        )
    }
})
