package badlog.expression

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import kotlin.random.Random

/** Makes random valid expressions over the signals of [randomSignals]. */
internal class RandomExpressions(private val random: Random) {
    fun any(): String = if (random.nextBoolean()) condition(4) else number(4)

    private fun <T> pick(vararg choices: T): T = choices[random.nextInt(choices.size)]

    private fun number(depth: Int): String = if (depth == 0 || random.nextInt(4) == 0) {
        pick("A", "B", "C", "Dir/D", "2", "0.5", "-1", "min(A)", "time")
    } else {
        when (random.nextInt(6)) {
            0 -> "(${number(depth - 1)} ${pick("+", "-", "*", "/", "%", "^")} ${number(depth - 1)})"

            1 -> "(${pick(series(depth), "A", "C", "1")} when ${condition(depth - 1)})"

            2 -> "${pick("abs", "sqrt", "sign", "floor", "round")}(${number(depth - 1)})"

            3 -> overTime(depth)

            4 -> figure(depth)

            else -> pick(
                "if(${condition(depth - 1)}, ${number(depth - 1)}, ${number(depth - 1)})",
                "clamp(${number(depth - 1)}, 0, 2)",
                "-${number(depth - 1)}",
            )
        }
    }

    private fun overTime(depth: Int): String = when (random.nextInt(5)) {
        0 -> "${pick("delta", "derivative", "hold", "previous")}(${series(depth)})"
        1 -> "shift(${series(depth)}, ${pick("0.5 s", "-0.25 s")})"
        2 -> pick("area(${lasting(depth)})", "mean(${lasting(depth)}, 1 s)", "min(${lasting(depth)}, 0.5 s)", "max(${lasting(depth)}, 2 s)")
        3 -> pick("lengths(${lastingCondition(depth)})", "cycle_times(${conditionOverTime(depth)})")
        else -> pick("number(E)", "number(E, 'y')", "number(T)")
    }

    private fun figure(depth: Int): String = when (random.nextInt(5)) {
        0 -> pick(
            "min", "max", "mean", "median", "stddev", "first", "last", "duration", "count", "time_of_min", "time_of_max",
            "sample_mean", "sample_median", "sample_stddev",
        ).let { "$it(${series(depth)})" }

        1 -> pick(
            "integral(${lasting(depth)})",
            "percentile(${series(depth)}, 30)",
            "sample_percentile(${series(depth)}, 70)",
            "duration(${pick("T", "E", "F", "hold(E)")})",
        )

        2 -> "${pick("slope", "correlation")}(${series(depth)}, ${series(depth)})"

        3 -> "total(${lastingCondition(depth)})"

        else -> "count(${pick(conditionOverTime(depth), "E", "T", "changed(S)")})"
    }

    // Contains a topic, so that it always changes over time.
    private fun series(depth: Int): String = "${number(depth - 1)} + ${pick("A", "B", "C", "Dir/D")}"

    // Of two alternatives, one lasts, so the whole lasts.
    private fun lasting(depth: Int): String = "if(${pick("F", "true or G")}, ${number(depth - 1)}, B) + ${pick("A", "B", "C", "Dir/D")}"

    private fun conditionOverTime(depth: Int): String = "(${condition(depth - 1)} ${pick("and", "or")} ${pick("F", "G", "B > 0", "C < 1")})"

    private fun lastingCondition(depth: Int): String = "((${condition(depth - 1)} or ${pick("F", "G", "B > 9")}) ${pick("and", "or")} ${pick("F", "G", "B > 0", "C < 1")})"

    private fun condition(depth: Int): String = if (depth == 0 || random.nextInt(5) == 0) {
        pick(
            "F", "G", "true", "S == 'a'", "S != 'b'", "T = S", "E contains 'X'", "E matches '?*y*'", "enabled", "autonomous", "teleop", "time > 2",
            "missing(C)", "changed(S)", "changed(T)", "A > 0",
        )
    } else {
        when (random.nextInt(9)) {
            0 -> "(${condition(depth - 1)} ${pick("and", "or", "&&", "||")} ${condition(depth - 1)})"

            1 -> "not ${condition(depth - 1)}"

            2 -> pick("(${lastingCondition(depth)} for ${pick("0.25 s", "0.5 s", "1 s")})", "(hold(E) ${pick("==", "!=")} 'Xerxes' for ${pick("0.25 s", "0.5 s")})")

            3 -> pick("any", "all").let { "$it(${conditionOverTime(depth)})" }

            4 -> "during(${pick("1", "2 s", "time_of_min(A)")}, 3.25 s)"

            5 -> pick("rises", "falls", "changed").let { "$it(${conditionOverTime(depth)})" }

            6 -> pick(
                "${pick("after", "before")}(${conditionOverTime(depth)}, ${pick("0.5 s", "1 s")})",
                "${pick("first", "last")}(${lastingCondition(depth)}, ${pick("0.5 s", "2 s")})",
                "(${conditionOverTime(depth)} within 1 s ${pick("after", "before")} ${conditionOverTime(depth)})",
            )

            7 -> "crosses(${series(depth)}, ${pick("0", "1", number(depth - 1))})"

            else -> "(${number(depth - 1)} ${pick("<", "<=", ">", ">=", "==", "!=", "=")} ${number(depth - 1)})"
        }
    }
}

/** A, B, F and S share their times; C, Dir/D, G, T and the events E have their own. Some are empty, some have gaps. */
internal fun randomSignals(random: Random): Signals {
    fun times(most: Int) = List(random.nextInt(most + 1)) { random.nextInt(24) * 0.25 }.distinct().sorted().toDoubleArray()
    fun numbers(x: DoubleArray) = Series(
        x,
        DoubleArray(x.size) { if (random.nextInt(5) == 0) Double.NaN else random.nextInt(-2, 4).toDouble() },
    )
    fun among(x: DoubleArray, count: Int, hasGaps: Boolean = true) = Series(x, DoubleArray(x.size) { if (hasGaps && random.nextInt(5) == 0) Double.NaN else random.nextInt(count).toDouble() })
    // In every third recording, the clock was set back.
    val common = if (random.nextInt(3) > 0) times(14) else times(6) + times(6) + times(3)
    val edges = List(4) { random.nextInt(24) * 0.25 }.sorted()
    val isMeasured = edges.distinct().size == 4
    return SampleSignals(
        mapOf(
            Signal("A", SignalKind.NUMBER) to numbers(common),
            Signal("B", SignalKind.NUMBER) to numbers(common),
            Signal("C", SignalKind.NUMBER) to numbers(times(8)),
            Signal("Dir/D", SignalKind.NUMBER) to numbers(times(4)),
            Signal("F", SignalKind.CONDITION) to among(common, 2),
            Signal("G", SignalKind.CONDITION) to among(times(5), 2),
            Signal("S", SignalKind.STATE) to among(common, 3),
            Signal("T", SignalKind.STATE) to among(times(5), 2),
            Signal("E", SignalKind.EVENT) to among(times(4), 3, hasGaps = false),
        ),
        texts = mapOf("S" to listOf("a", "b", "c"), "T" to listOf("c", "a 1.5"), "E" to listOf("xy -2", "Xerxes", "3 y 1.0E-1")),
        rows = common,
        enabled = if (isMeasured) {
            listOf(
                EnabledSpan(Span(edges[0], edges[1]), true),
                EnabledSpan(Span(edges[2], edges[3]), false),
            )
        } else {
            emptyList<EnabledSpan>().takeIf { random.nextBoolean() }
        },
    )
}
