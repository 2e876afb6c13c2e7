package badlog.viewer.draw.mark

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Value
import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class ClocksSpec : FunSpec({
    val match = ModeTimeline(listOf(ModeSpan(Span(11.0, 200.0), RobotMode.TELEOP)), 1.0)

    fun clocks(start: String?, unit: String = "s"): Clocks {
        val view = bagView(listOf("Time|xaxis", "A"), listOf("10,1", "200,1"))
        val topics = view.recording.topics.map { if (it.name == "Time") it.copy(unit = unit) else it }
        val values = listOfNotNull(start?.let { Value("Start Time", it) })
        return Clocks(LogView.of(view.recording.copy(topics = topics, values = values)), match)
    }

    test("the time of day continues from the log's start, also past midnight, beside the match clock") {
        clocks("2024-03-09 14:02:31 UTC").textAt(94.6) shouldBe "Teleop 1:23 · 14:03:55"
        clocks("2024-03-14T23:59:58").dayAt(13.0) shouldBe "00:00:01"
        clocks("2024-03-14T23:59:58.900").dayAt(10.2) shouldBe "23:59:59"
    }

    test("without a start, or a time on x, there is no time of day") {
        clocks(null).textAt(94.6) shouldBe "Teleop 1:23"
        clocks("yesterday").dayAt(94.6) shouldBe null
        clocks("2024-03-14T23:59:58", "m").dayAt(94.6) shouldBe null
        clocks("2024-03-14T23:59:58").dayAt(Double.NaN) shouldBe null
    }
})
