package badlog.expression

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.expression.samples.Scalar
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private val X = doubleArrayOf(0.0, 1.0, 2.0, 3.0, 4.0)
private val GAP = Double.NaN

private fun series(vararg y: Double) = Series(X, y)

private val SIGNALS = SampleSignals(
    mapOf(
        Signal("v", SignalKind.NUMBER, "V") to series(12.0, 8.0, 6.0, GAP, 10.0),
        Signal("i", SignalKind.NUMBER, "A") to series(1.0, 2.0, 4.0, 4.0, 3.0),
        Signal("on", SignalKind.CONDITION) to series(0.0, 1.0, 1.0, 0.0, 1.0),
        Signal("slow", SignalKind.NUMBER) to Series(doubleArrayOf(0.5, 2.5), doubleArrayOf(5.0, 7.0)),
        Signal("state", SignalKind.STATE) to series(0.0, 0.0, 1.0, GAP, 1.0),
        Signal("log", SignalKind.EVENT) to Series(doubleArrayOf(1.0, 1.5, 4.0), doubleArrayOf(0.0, 1.0, 0.0)),
        Signal("angle", SignalKind.NUMBER) to series(0.25, 0.5, -0.5, 1.0, 0.0),
        Signal("back", SignalKind.NUMBER) to Series(doubleArrayOf(1.0, 0.0, 2.0), doubleArrayOf(10.0, 20.0, 30.0)),
    ),
    texts = mapOf("state" to listOf("IDLE", "SHOOT"), "log" to listOf("CAN timeout", "brownout")),
    enabled = listOf(EnabledSpan(Span(1.0, 2.0), true), EnabledSpan(Span(2.0, 3.5), false)),
    rows = X,
)

private fun parsed(text: String) = parsed(text, SIGNALS.vocabulary)

private fun rounded(value: Double) = if (value.isNaN()) "-" else readable(value)

class FunctionsSpec : FunSpec({
    val summaries = mapOf(
        "min(v)" to "6", "max(v)" to "12", "mean(v)" to "8.66667", "median(v)" to "8", "percentile(v, 0)" to "6",
        "percentile(v, 95)" to "12", "median(on)" to "0.5",
        "sample_mean(v)" to "9", "sample_median(v)" to "9", "sample_percentile(v, 95)" to "11.7", "sample_stddev(v)" to "2.58199",
        "percentile(v, 100)" to "12", "stddev(v)" to "2.49444", "first(v)" to "12", "last(v)" to "10", "integral(v)" to "26",
        "integral(i)" to "11",
        "duration(v)" to "4", "duration(slow)" to "3.5", "count(v)" to "4", "count(on)" to "2", "count(log)" to "3",
        "count(changed(state))" to "1",
        "time_of_min(v)" to "2", "time_of_max(v)" to "0", "any(v < 7)" to "1", "any(v < 5)" to "0", "all(v > 5)" to "1",
        "all(v > 6)" to "0",
        "total(on)" to "2", "total(v < 9)" to "2", "mean(on)" to "0.5", "any((v > 9) when v > 99)" to "-",
        "min(v when on)" to "6", "max(v when not on)" to "12", "min(i when during(3, 5))" to "3", "min(v when v > 99)" to "-",
        "total(enabled)" to "2.5", "total(autonomous)" to "1", "total(teleop)" to "1.5", "max(time)" to "4", "max(time when on)" to "4", "total(time > 1:01)" to "0", "max(v when enabled)" to "8", "max(i when autonomous)" to "2",
        "total(during(1 s, 2500 ms))" to "1.5", "count(log contains 'can')" to "2", "count(log matches 'can*')" to "2",
        "count(log matches 'can')" to "0",
        "count(log == 'brownout')" to "1", "any(log contains 'fire')" to "0",
        "total(state == 'IDLE')" to "2", "total(state != 'IDLE')" to "1",
        "count(rises(on))" to "2", "count(falls(on))" to "1", "count(crosses(i, 2))" to "1", "max(lengths(on))" to "2",
        "count(lengths(on))" to "2", "max(cycle_times(on))" to "3", "total(after(on, 0.5 s))" to "2.5",
        "total(before(on, 0.5 s))" to "1", "total(first(on, 1 s))" to "1", "total(last(i > 1, 1 s))" to "1",
        "min(v when last(teleop, 1 s))" to "6", "slope(2 * i + 1, i)" to "2", "correlation(i, i)" to "1", "correlation(i, -i)" to "-1",
        "slope(i, i - i)" to "-", "count(number(log))" to "0",
        "count(log contains 'brown' within 1 s after log contains 'CAN')" to "1",
        "count(log contains 'brown' within 0.1 s after log contains 'CAN')" to "0",
        "count(log contains 'can' within 600 ms before log == 'brownout')" to "1", "total(i > 1 within 1 s before on)" to "1",
        "min(v) + 2 * max(i)" to "14", "2 ^ 3 % 5" to "3", "-2 ^ 2" to "-4", "7 - 2 - 1" to "4", "1 min - 1 s" to "59",
        "if(min(v) < 7, 1, 2)" to "1",
        "clamp(7, 1, 5)" to "5", "abs(-3)" to "3", "sign(-3)" to "-1", "sqrt(9)" to "3", "exp(0)" to "1", "log(exp(2))" to "2",
        "log10(1000)" to "3", "sin(0)" to "0",
        "cos(0)" to "1", "tan(0)" to "0", "asin(1)" to "1.5708", "acos(1)" to "0", "atan(1)" to "0.785398",
        "atan2(1, -1)" to "2.35619", "floor(1.5)" to "1",
        "ceil(1.5)" to "2", "round(1.6)" to "2", "last(back)" to "30", "first(back)" to "10",
        "duration(back)" to "2", "min(delta(back))" to "10", "count(back < 20)" to "1", "count(back > 15)" to "1",
        "total(back > 0)" to "2", "total(back > 15)" to "2", "integral(back)" to "40", "time_of_min(back)" to "1",
        "max(derivative(back))" to "5", "count(back + v > 0)" to "2",
    )
    for ((text, result) in summaries) {
        test("$text is $result") {
            val expression = parsed(text)
            val value = Evaluation(SIGNALS, expression.root.id + 1).valueOf(expression.root) as Scalar
            rounded(value.value) shouldBe result
        }
    }

    val overTime = mapOf(
        "v * i" to "12 16 24 - 30",
        "delta(v)" to "- -4 -2 - -",
        "derivative(i)" to "1 2 -0.5 -0.5 0",
        "area(i)" to "0 1 3 7 11",
        "area(v)" to "0 12 20 - 26",
        "previous(i)" to "- 1 2 2 4",
        "hold(v)" to "12 8 6 6 10",
        "changed(i)" to "0 1 1 0 1",
        "changed(state)" to "0 0 1 0 0",
        "missing(v)" to "0 0 0 1 0",
        "mean(i, 2 s)" to "1 1 1.5 3 4",
        "min(v, 2 s)" to "12 8 6 6 6",
        "max(v, 2 s)" to "12 12 12 8 10",
        "abs(angle)" to "0.25 0.5 0.5 1 0",
        "sin(angle)" to "0.247404 0.479426 -0.479426 0.841471 0",
        "clamp(i, 2, 3)" to "2 2 3 3 3",
        "if(on, v, 0)" to "0 8 6 0 10",
        "v < 9" to "0 1 1 - 0",
        "not (v < 9)" to "1 0 0 - 1",
        "v < 9 or i > 3" to "0 1 1 1 0",
        "v < 9 and i > 3" to "0 0 1 - 0",
        "on == (i > 1)" to "1 1 1 0 1",
        "v when on" to "- 8 6 - 10",
        "state == 'IDLE'" to "1 1 0 - 0",
    )
    for ((text, result) in overTime) {
        test("$text is $result") {
            val samples = parsed(text).series(SIGNALS)
            samples.x.toList() shouldBe X.toList()
            samples.y.joinToString(" ", transform = ::rounded) shouldBe result
        }
    }

    fun pairs(text: String): String {
        val series = parsed(text).series(SIGNALS)
        return series.x.indices.joinToString { "${rounded(series.x[it])}:${rounded(series.y[it])}" }
    }

    test("topics with times of their own are joined at all times, each holding its last value") {
        pairs("v + slow") shouldBe "0:-, 0.5:17, 1:13, 2:11, 2.5:13, 3:-, 4:17"
    }

    test("a condition that holds long enough counts from its start; a shorter one does not count") {
        pairs("on for 1.5 s") shouldBe "0:0, 1:1, 2:1, 3:0, 4:0"
        pairs("i > 0 for 4 s") shouldBe "0:1, 1:1, 2:1, 3:1, 4:1"
        pairs("on for 2 s") shouldBe "0:0, 1:1, 2:1, 3:0, 4:0"
        pairs("on for 2.5 s") shouldBe "0:0, 1:0, 2:0, 3:0, 4:0"
    }

    test("decimal times are compared exactly") {
        val x = DoubleArray(60) { 9.5 + it * 0.02 }
        val y = DoubleArray(60) { if (it in 1..25) 1.0 else 0.0 }
        val signals = SampleSignals(mapOf(Signal("c", SignalKind.CONDITION) to Series(x, y)))
        parsed("c for 0.5 s", signals.vocabulary).series(signals).y.toList() shouldBe y.toList()
    }

    test("shift moves samples in time") {
        pairs("shift(slow, 0.25 s)") shouldBe "0.75:5, 2.75:7"
        pairs("shift(slow, -0.5 s)") shouldBe "0:5, 2:7"
    }

    test("an event is true at its moment only") {
        pairs("log contains 'can'") shouldBe "0:0, 1:1, 2:0, 3:0, 4:1"
        parsed("log contains 'can' and on").answer(SIGNALS).spans shouldBe listOf(Span(1.0, 1.0), Span(4.0, 4.0))
        parsed("log contains 'can' or i > 3").answer(SIGNALS).spans shouldBe listOf(Span(1.0, 1.0), Span(2.0, 4.0))
        parsed("total(log contains 'can' or i > 3)").answer(SIGNALS).quantities.single().value shouldBe 2.0
    }

    test("a text's number is the first one in it, or the first one after a mark") {
        val texts = listOf("CAN1 timeout after 12.5 ms at -3", "no number here", "voltage 6.9", "v-2 is 7")
        val log = Signal("log", SignalKind.EVENT) to Series(doubleArrayOf(0.0, 1.0, 2.0, 3.0), doubleArrayOf(0.0, 1.0, 2.0, 3.0))
        val signals = SampleSignals(mapOf(log), mapOf("log" to texts), rows = doubleArrayOf(0.0, 1.0, 2.0, 3.0))
        fun numbers(text: String) = parsed(text, signals.vocabulary).series(signals).y.joinToString(" ", transform = ::rounded)
        numbers("number(log)") shouldBe "12.5 - 6.9 2"
        numbers("number(log, 'at')") shouldBe "-3 - - -"
        numbers("number(log, 'VOLTAGE')") shouldBe "- - 6.9 -"
    }

    test("a number in a text is read whole: fractions, exponents as Java writes them, but no version and no address") {
        val texts = mapOf(
            "error 1.0E-4 rad" to "0.0001", "gain 2e3" to "2000", "offset .5" to "0.5", "offset -.5" to "-0.5", "takes 3e" to "3",
            "1.2.3 at 10.0.0.2" to "-", "version 1.2.3 of 2026" to "2026", "12V" to "12", "7.5, then 8." to "7.5", "e5" to "-",
        )
        for ((text, wanted) in texts) {
            val log = Signal("log", SignalKind.EVENT) to Series(doubleArrayOf(0.0), doubleArrayOf(0.0))
            val signals = SampleSignals(mapOf(log), mapOf("log" to listOf(text)))
            rounded(parsed("number(log)", signals.vocabulary).series(signals).y[0]) shouldBe wanted
        }
    }

    test("rounding adds no changes to a constant") {
        val x = DoubleArray(50) { it * 0.7 }
        val signals = SampleSignals(
            mapOf(
                Signal("same", SignalKind.NUMBER) to Series(x, DoubleArray(50) { 0.1 }),
                Signal("up", SignalKind.NUMBER) to Series(x, DoubleArray(50) { it * 0.1 }),
            ),
        )
        fun number(text: String) = parsed(text, signals.vocabulary).answer(signals).quantities.single().value
        number("count(changed(mean(same, 3 s)))") shouldBe 0.0
        number("max(same) - mean(same)") shouldBe 0.0
        parsed("correlation(up, 3 * up) <= 1 and correlation(up, -3 * up) >= -1", signals.vocabulary).answer(signals).matches shouldBe true
    }

    test("a condition that holds until the end of the log is true at the end") {
        pairs("last(i > 2, 1 s)") shouldBe "0:0, 3:1"
        pairs("first(i > 2, 9 s)") shouldBe "0:0, 2:1"
        parsed("min(i when last(i > 2, 0.5 s))").answer(SIGNALS).quantities.single().value shouldBe 3.0
    }

    test("a condition shifted beyond the end of the log does not become false there") {
        parsed("count(falls(shift(on, 1.5 s)))").answer(SIGNALS).quantities.single().value shouldBe 0.0
    }

    test("hold turns events into a state") {
        pairs("hold(log) contains 'can'") shouldBe "1:1, 1.5:0, 4:1"
        parsed("hold(log) == 'brownout' for 1 s").answer(SIGNALS).spans shouldBe listOf(Span(1.5, 4.0))
        parsed("total(hold(log) == 'brownout')").answer(SIGNALS).quantities.single().value shouldBe 2.5
    }

    test("if time goes back, samples stay in order, and later samples have later times") {
        pairs("back + 0") shouldBe "1:10, 0:20, 2:30"
        pairs("previous(back)") shouldBe "1:-, 0:10, 2:20"
        pairs("derivative(back)") shouldBe "1:-, 0:5, 2:0"
        pairs("shift(back, 0.5 s)") shouldBe "0.5:10, 0.5:20, 2.5:30"
        pairs("back > 15 for 1 s") shouldBe "1:0, 0:1, 2:1"
    }

    test("if time goes back, samples of another clock count at each occurrence of their time") {
        pairs("back + v") shouldBe "0:-, 1:18, 0:32, 1:28, 2:36, 3:-, 4:40"
        pairs("back > 0 and during(1, 2)") shouldBe "0:0, 1:1, 0:0, 1:1, 2:0"
    }

    test("a condition that holds while the clock is set back has two spans, but one occurrence") {
        parsed("back > 0").answer(SIGNALS).toString() shouldBe
            "yes, back = 30 at 2 s, at 1 s, in 2 parts since the clock was set back"
    }

    test("one number for the whole log is a line through it") { pairs("min(v)") shouldBe "0:6, 4:6" }

    test("times in any written unit are converted to the unit of x") {
        val signals = SampleSignals(
            mapOf(Signal("c", SignalKind.CONDITION) to Series(doubleArrayOf(0.0, 100.0, 900.0), doubleArrayOf(1.0, 1.0, 0.0))),
            timeUnit = "ms",
        )
        parsed(
            "total(c) > 0.8 s",
            signals.vocabulary,
        ).answer(signals).toString() shouldBe "yes, total(c) = 900 ms at 0 ms, from 0 ms to 900 ms"
        parsed("c for 0.2 s", signals.vocabulary).answer(signals).spans shouldBe listOf(Span(0.0, 900.0))
    }

    val answers = mapOf(
        "min(v) < 7" to "yes, min(v) = 6 V at 2 s",
        "min(v) < 5" to "no, min(v) = 6 V at 2 s",
        "v < 9" to "yes, v = 6 V at 2 s, from 1 s to 3 s",
        "v < 5" to "no",
        "(v - 1) < 9 and i < 3" to "yes, (v - 1) = 7 at 1 s, i = 2 A at 1 s, from 1 s to 2 s",
        "min(v when v > 99) < 7" to "not known, min(v when v > 99) = no value",
        "v > 5 when v > 99" to "not known",
        "7 when on" to "min(7 when on) = 7 at 1 s, max(7 when on) = 7 at 1 s",
        "9 > v for 1 s" to "yes, v = 6 V at 2 s, from 1 s to 3 s",
        "not (v >= 9)" to "yes, v = 6 V at 2 s, from 1 s to 3 s",
        "i >= 3" to "yes, i = 4 A at 2 s, from 2 s to 4 s",
        "i > 1 and i != 4" to "yes, i = 3 A at 4 s, i = 2 A at 1 s, from 1 s to 2 s, and once more",
        "any(v < 9)" to "yes, v = 6 V at 2 s, from 1 s to 3 s",
        "all(v > 5)" to "yes",
        "all(v > 7)" to "no, v = 6 V at 2 s",
        "not all(v > 7)" to "yes, v = 6 V at 2 s",
        "count(on) > 1" to "yes, count(on) = 2 at 1 s, from 1 s to 3 s, and once more",
        "count(on) > 1 and min(v) < 7" to "yes, count(on) = 2 at 1 s, min(v) = 6 V at 2 s, from 1 s to 3 s, and once more",
        "log contains 'CAN'" to "yes, at 1 s, and once more",
        "log contains 'fire'" to "no",
        "max(v) - min(v)" to "max(v) - min(v) = 6 V",
        "v" to "min(v) = 6 V at 2 s, max(v) = 12 V at 0 s",
        "time_of_min(v) > 1 s" to "yes, time_of_min(v) = 2 s at 2 s",
        "max(derivative(i)) > 1" to "yes, max(derivative(i)) = 2 A/s at 1 s",
        "integral(i) > 10" to "yes, integral(i) = 11 A·s",
        "true" to "yes",
    )
    for ((text, answer) in answers) {
        test("the answer to $text is “$answer”") { parsed(text).answer(SIGNALS).toString() shouldBe answer }
    }

    test("if the log does not show when the robot was enabled, the answer is unknown, with the reason") {
        val silent = SampleSignals(SIGNALS.vocabulary.signals.associateWith { SIGNALS.series(it.name) }, enabled = null)
        fun answer(text: String) = parsed(text, silent.vocabulary).answer(silent)
        for (text in listOf("total(enabled)", "count(i > 1 and enabled)", "max(v when enabled)", "total(enabled) / 60")) {
            answer(text).quantities.single().value.isNaN() shouldBe true
            answer(text).reason shouldBe "The log does not show when the robot was enabled."
        }
        for (text in listOf("i > 1 and enabled", "any(enabled)", "count(enabled) == 0", "not enabled")) {
            answer(text).outcome shouldBe Outcome.UNKNOWN
            answer(text).reason shouldBe "The log does not show when the robot was enabled."
        }
        answer("i > 99 and enabled").run { outcome to reason } shouldBe (Outcome.FAILS to null)
        answer("max(i)").reason shouldBe null
    }

    test("without samples the answer is unknown") {
        val empty = SampleSignals(
            SIGNALS.vocabulary.signals.associateWith { Series(DoubleArray(0), DoubleArray(0)) },
            mapOf("state" to emptyList(), "log" to emptyList()),
        )
        for (text in summaries.keys + overTime.keys + answers.keys) {
            parsed(text).run {
                answer(empty).toString()
                series(empty)
            }
        }
        parsed("min(v) < 7").answer(empty).outcome shouldBe Outcome.UNKNOWN
        parsed("count(log contains 'x') == 0").answer(empty).outcome shouldBe Outcome.HOLDS
    }

    test("numbers are shown with six digits on every platform") {
        listOf(
            0.0, 6.7, -6.7, 1234567.0, 0.1 + 0.2, 0.000012345678, 1e-7, 1.5e20, 9.9999999, 999999.9, 1e300, 5e-324,
            9999999999.0, Double.POSITIVE_INFINITY,
        )
            .map(::readable) shouldBe listOf(
            "0", "6.7", "-6.7", "1234567", "0.3", "0.0000123457", "1e-7", "1.5e+20", "10", "1000000", "1e+300", "4.94066e-324",
            "9999999999", "infinite",
        )
    }
})
