package badlog.expression

import badlog.analysis.LogView
import badlog.plot.Span
import badlog.wpilog.TestLog
import badlog.wpilog.parseLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class LogViewSignalsSpec : FunSpec({
    val log = TestLog().start(1, "volts", "double").start(2, "messages", "string").start(3, "mode", "string")
        .double(1, 1_000_000, 12.0).double(1, 5_000_000, 6.5).double(1, 6_000_000, 11.0)
        .string(2, 2_500_000, "hello").string(2, 7_000_000, "brownout")
        .string(3, 500_000, "auto").string(3, 3_000_000, "teleop")
    val signals = LogViewSignals(LogView.of(parseLog(log.bytes)))

    fun answer(text: String) = parsed(text, signals.vocabulary).answer(signals).toString()

    test("the range of a WPILOG is that of all its clocks, in s") {
        signals.range shouldBe Span(0.5, 7.0)
        signals.timeUnit shouldBe "s"
    }

    test("events and states of a WPILOG stand at their own times") {
        signals.series("messages").x.toList() shouldBe listOf(2.5, 7.0)
        signals.series("messages").y.toList() shouldBe listOf(0.0, 1.0)
        signals.series("mode").x.toList() shouldBe listOf(0.5, 3.0)
    }

    test("expressions join topics of different clocks") {
        answer("min(volts) < 7") shouldBe "yes, min(volts) = 6.5 at 5 s"
        answer("messages == 'brownout'") shouldBe "yes, at 7 s"
        answer("volts < 7 and mode == 'teleop'") shouldBe "yes, volts = 6.5 at 5 s, from 5 s to 6 s"
    }
})
