package badlog.viewer.shown.cursor

import badlog.core.analysis.LogView
import badlog.viewer.bagView
import badlog.viewer.text.exactText
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class CursorComparisonSpec : FunSpec({
    fun LogView.compared(name: String, a: Double, b: Double) = seriesOf(recording.topics.single { it.name == name }).comparisonText(a, b, "s", ::exactText)

    val rows = bagView(listOf("Time|xaxis", "A", "Mode"), listOf("0,12.1,auto", "1,,teleop", "2,9.3,teleop"))

    test("a number has its values at both cursors, their difference without made-up digits, and the slope between the samples") {
        rows.compared("A", 0.1, 1.9) shouldBe "A 12.1 · B 9.3 · Δ -2.8 · -1.4 V/s"
        rows.compared("A", 1.9, 0.1) shouldBe "A 9.3 · B 12.1 · Δ 2.8 · -1.4 V/s"
    }

    test("a gap and a state have no difference, and one sample has no slope") {
        rows.compared("A", 0.0, 1.0) shouldBe "A 12.1 · B –"
        rows.compared("Mode", 0.0, 1.0) shouldBe "A auto · B teleop"
        rows.compared("A", 0.0, 0.1) shouldBe "A 12.1 · B 12.1 · Δ 0"
    }

    test("a held value changes over the time between the cursors, not between its samples") {
        timedView(timedTopic("A", 0.0 to 1.0, 4.0 to 3.0), timedTopic("End", 6.0 to 0.0)).compared("A", 3.0, 5.0) shouldBe "A 1 · B 3 · Δ 2 · 1 V/s"
    }
})
