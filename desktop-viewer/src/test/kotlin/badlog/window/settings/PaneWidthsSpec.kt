package badlog.window.settings

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.floats.plusOrMinus
import io.kotest.matchers.floats.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe

class PaneWidthsSpec : FunSpec({
    fun PaneWidths.sum() = logs + topics + details

    test("a wide window has the stored widths of its parts") {
        PaneWidths().within(1358f, hasLogs = true, hasTopics = true, hasDetails = true) shouldBe PaneWidths()
        PaneWidths().within(1358f, hasLogs = true, hasTopics = false, hasDetails = false) shouldBe PaneWidths(280f, 0f, 0f)
    }

    test("in a small window the parts make room for the graphs") {
        val narrow = PaneWidths().within(900f, hasLogs = true, hasTopics = true, hasDetails = true)
        900f - narrow.sum() shouldBeGreaterThanOrEqual 399f
        val two = PaneWidths().within(900f, hasLogs = true, hasTopics = true, hasDetails = false)
        900f - two.sum() shouldBe (400f plusOrMinus 1f)
    }

    test("a drag begins at the visible width, and a damaged width counts as the minimum") {
        val wanted = PaneWidths(600f, 600f, 600f)
        val seen = wanted.within(900f, hasLogs = true, hasTopics = true, hasDetails = false)
        wanted.draggedFrom(seen, PaneWidths(10f, 0f, 0f)) shouldBe PaneWidths(seen.logs + 10f, seen.topics, 600f)
        PaneWidths(Float.NaN, -5f, 1e9f).within(5000f, hasLogs = true, hasTopics = true, hasDetails = true) shouldBe PaneWidths(150f, 140f, 1200f)
    }
})
