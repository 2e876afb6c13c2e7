package badlog.viewer.window

import badlog.viewer.compare.Alignment
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.library.putSamples
import badlog.viewer.panels.MainView
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent

class CompareWindowSpec : FunSpec({
    test("two matches that are ticked lie over each other, and a table has their figures").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val folder = tempdir().toPath().also { it.putSamples() }
        RealWindow(tempdir().toPath(), folder.resolve("qualification-42.bag")).use { window ->
            window.awaitState("the match, and all logs") { it.open != null && it.library.entries.size == 4 && it.library.reading == null }
            window.click("Compare qualification-42.bag")
            window.click("Compare qualification-57.bag.gz")
            window.awaitState("two recordings") { it.drawnRecordings().size == 2 }
            window.look { viewer -> viewer.comparison.ticked.size } shouldBe 2
            window.click(Alignment.ENABLED.hint)
            window.awaitState("the alignment") { it.comparison.alignment == Alignment.ENABLED }
            window.awaitGraphs()
            window.point("Plot Arm/Angle", 0.5, 0.5)
            window.picture("compare")

            window.press(KeyEvent.VK_S)
            window.awaitState("the statistics") { it.panels.main == MainView.STATISTICS }
            window.awaitState("the battery") { it.statisticsChoice.topics == listOf("System/Battery Voltage") }
            window.click("Search topics for the table")
            window.type("total current")
            window.click("Figures of PDP/Total Current")
            window.awaitState("one more topic") { "PDP/Total Current" in it.statisticsChoice.topics }
            window.picture("statistics")
        }
    }
})
