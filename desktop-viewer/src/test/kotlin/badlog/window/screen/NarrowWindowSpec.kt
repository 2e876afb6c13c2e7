package badlog.window.screen

import badlog.catalog.folder.putSamples
import badlog.catalog.folder.samples
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import java.awt.event.KeyEvent

@Tags("InCheck")
class NarrowWindowSpec : FunSpec({
    test("a window as narrow as a phone shows one part at a time").config(enabledOrReasonIf = { needsDisplay }) {
        val folder = tempdir().toPath().also { it.putSamples() }
        RealWindow(tempdir().toPath(), folder.resolve("qualification-42.bag"), width = 420, height = 800).use { window ->
            window.awaitLogs(4)
            window.awaitGraphs()
            window.picture("narrow-graphs")
            window.click("Show the logs")
            window.awaitText("Log practice.bag")
            window.picture("narrow-logs")
            window.click("Show the topics")
            window.awaitText("Topic Arm/Angle")
            window.picture("narrow-topics")
            window.click("Show the details")
            window.awaitText("Search events")
            window.picture("narrow-details")

            window.click("Close the panel")
            window.awaitState("the graphs again") { it.panels.state.front == FrontPart.GRAPHS }
            window.press(KeyEvent.VK_3, KeyEvent.VK_CONTROL)
            window.awaitState("the problems") { it.panels.state.front == FrontPart.DETAILS }
            window.awaitState("their panel") { it.panels.state.inspector == InspectorTab.PROBLEMS }
            window.picture("narrow-problems")

            window.press(KeyEvent.VK_F1)
            window.awaitText("Keys and gestures sheet")
            window.picture("narrow-help")
            window.press(KeyEvent.VK_ESCAPE)
            window.press(KeyEvent.VK_S)
            window.awaitText("Back to the graphs")
            window.picture("narrow-statistics")
            window.press(KeyEvent.VK_T)
            window.awaitText("Table of logs")
            window.picture("narrow-table")
            window.click("Show the logs")
            window.awaitNo("Table of logs")
            window.click("Log practice.bag")
            window.awaitState("the other log in front") {
                it.current.recording?.file == folder.resolve("practice.bag") && it.panels.state.front == FrontPart.GRAPHS
            }
        }
    }

    test("the smallest window with lists leaves room for the graphs beside all open parts, and a drag makes a part wider").config(enabledOrReasonIf = { needsDisplay }) {
        RealWindow(tempdir().toPath(), samples.resolve("qualification-42.bag"), width = 1120, height = 600).use { window ->
            window.awaitState("the match") { it.current.recording != null }
            window.press(KeyEvent.VK_5, KeyEvent.VK_CONTROL)
            window.awaitGraphs()
            // Beside the axis on the right, which the first graph needs.
            window.awaitState("room for graphs") { viewer -> viewer.graphs.plots.state(viewer.board.state.graphs[0].id).size.width > 240 }
            window.picture("small-window")
            val before = window.look { it.settings.state.panes.details }
            window.drag("Width of the panel", 0.5, 0.5, -8.0, 0.5)
            window.awaitState("another width") { it.settings.state.panes.details != before }
            window.press(KeyEvent.VK_T)
            window.awaitText("Table of logs")
            window.picture("small-table")
        }
    }
})
