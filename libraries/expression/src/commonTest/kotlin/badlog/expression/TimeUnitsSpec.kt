package badlog.expression

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.expression.signals.Signals
import badlog.expression.syntax.ExpressionErrorKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

/** 100 rows, [step] apart, in which V counts up. If [unit] is null, the rows have no x axis. */
private fun signals(step: Double, unit: String?): Signals {
    val attributes = if (unit == null) "" else """"xaxis""""
    val header = """{"topics":[{"name":"Time","unit":"${unit.orEmpty()}","attrs":[$attributes]},{"name":"V","unit":"V"}],"values":[]}"""
    val bag = header + "\nTime,V\n" + List(100) { "${it * step},$it\n" }.joinToString("")
    return LogViewSignals(LogView.of(BagParser().apply { accept(bag.encodeToByteArray()) }.finish()))
}

class TimeUnitsSpec : FunSpec({
    for ((unit, step) in mapOf(
        "s" to 0.02, "Seconds" to 0.02, "ms" to 20.0, "milliseconds" to 20.0, "us" to 2e4, "ns" to 2e7,
        "minutes" to 0.02 / 60, "h" to 0.02 / 3600, "" to 0.02,
    )) {
        test("a second is converted if x is in “$unit”") {
            val signals = signals(step, unit)
            parsed("V >= 50 for 0.97 s", signals.vocabulary).answer(signals).times shouldBe 1
            parsed("V >= 50 for 0.99 s", signals.vocabulary).answer(signals).times shouldBe 0
            readable(parsed("max(V - min(V, 1 s))", signals.vocabulary).answer(signals).quantities.single().value) shouldBe "50"
        }
    }

    for (unit in listOf(null, "m", "rows")) {
        test("a time is a mistake if x is in “$unit”") {
            errorOf("V >= 50 for 0.5 s", signals(1.0, unit).vocabulary).kind shouldBe ExpressionErrorKind.NO_TIME
        }
    }

    test("a virtual topic does not change times") {
        val signals = signals(1.0, null)
        val with = signals.with(VirtualTopic.parse("Twice = 2 * V", signals.vocabulary) as VirtualTopic)
        errorOf("Twice >= 50 for 0.5 s", with.vocabulary).kind shouldBe ExpressionErrorKind.NO_TIME
        parsed("count(Twice >= 50)", with.vocabulary).answer(with).quantities.single().value shouldBe 1.0
    }
})
