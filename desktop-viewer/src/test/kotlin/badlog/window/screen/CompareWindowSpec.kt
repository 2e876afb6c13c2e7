package badlog.window.screen

import badlog.catalog.folder.putSamples
import badlog.viewer.choices.comparison.Alignment
import badlog.window.sidebar.MainView
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent
import java.nio.file.Files

@Tags("InCheck")
class CompareWindowSpec : FunSpec({
    test("two checked matches are drawn over each other, and a table has their statistics").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val folder = Files.createDirectories(tempdir().toPath().resolve("Mill Creek")).also { it.putSamples() }
        RealWindow(tempdir().toPath(), folder.resolve("qualification-42.bag")).use { window ->
            window.awaitLogs(4)
            window.click("Compare qualification-42.bag")
            window.awaitState("the first one") { it.compared.state.checked.size == 1 }
            window.click("Compare qualification-57.bag.gz")
            window.awaitState("two recordings") { it.compared.drawn.size == 2 }
            window.look { viewer -> viewer.compared.state.checked.size } shouldBe 2
            window.click(Alignment.ENABLED.hint)
            window.awaitState("the alignment") { it.compared.state.offsets.alignment == Alignment.ENABLED }
            window.awaitGraphs()
            window.point("Plot Battery and current", 0.5, 0.5)
            window.picture("compare", guide = "viewer-compare")

            window.press(KeyEvent.VK_S)
            window.awaitState("the statistics") { it.panels.state.main == MainView.STATISTICS }
            window.awaitState("the battery") { it.view.across.topics == listOf("System/Battery Voltage") }
            window.click("Search topics for the table")
            window.type("total current")
            // The search runs off the window's thread.
            window.awaitNo("Statistics of Arm/Angle")
            window.click("Statistics of PDP/Total Current")
            window.awaitState("one more topic") { "PDP/Total Current" in it.view.across.topics }
            window.picture("statistics")
        }
    }
})
