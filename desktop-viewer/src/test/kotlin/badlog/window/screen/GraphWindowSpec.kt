package badlog.window.screen

import badlog.window.sidebar.InspectorTab
import badlog.window.theme.Theme
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent
import java.nio.file.Path
import kotlin.math.abs

@Tags("InCheck")
class GraphWindowSpec : FunSpec({
    val plot = "Plot Arm/Angle"

    /** Opens the window with a match. */
    fun open() = RealWindow(tempdir().toPath(), Path.of("../samples/qualification-42.bag")).apply {
        awaitState("the match") { it.current.recording != null }
        awaitGraphs()
    }

    test("the pointer zooms, goes back, selects, and reads values").config(enabledOrReasonIf = { needsDisplay }) {
        open().use { window ->
            val all = window.look { it.view.viewport.full }
            window.point(plot, 0.5, 0.5)
            window.wheel(-3, KeyEvent.VK_CONTROL)
            window.awaitState("a closer look") { it.view.viewport.visible.width < all.width * 0.7 }
            window.drag(plot, 0.25, 0.5, 0.75, 0.5)
            window.awaitState("half of that") { it.view.viewport.visible.width < all.width * 0.4 && it.view.gesture == null }
            window.awaitGraphs()
            window.picture("zoomed")
            window.click(plot, times = 2)
            window.awaitState("everything again") { it.view.viewport.visible == all }

            window.drag(plot, 0.5, 0.2, 0.5, 0.6, KeyEvent.VK_ALT)
            window.awaitState("a closer look at y") { viewer -> viewer.board.state.graphs.any { it.yRange != null } }
            window.awaitText("Reset Y zoom")
            window.click(plot, times = 2)
            window.awaitState("all of y") { viewer -> viewer.board.state.graphs.all { it.yRange == null } }

            window.press(KeyEvent.VK_4, KeyEvent.VK_CONTROL)
            window.awaitText("Statistics of Visible")
            window.drag(plot, 0.3, 0.5, 0.6, 0.5, KeyEvent.VK_CONTROL)
            window.awaitText("Statistics of Selected")
            window.awaitState("all of the selection") { abs((it.view.selection?.width ?: 0.0) - all.width * 0.3) < all.width * 0.02 && it.view.gesture == null }
            window.point(plot, 0.45, 0.5)
            window.awaitGraphs()
            window.picture("selection")
        }
    }

    test("Space plays and pauses, whatever was clicked before").config(enabledOrReasonIf = { needsDisplay }) {
        open().use { window ->
            window.press(KeyEvent.VK_SPACE)
            window.awaitState("the cursor to run") { it.player.state.isPlaying && it.view.cursor != null }
            window.press(KeyEvent.VK_SPACE)
            window.awaitState("the cursor to stand") { !it.player.state.isPlaying }

            window.click("Theme: system")
            window.awaitState("the dark theme") { it.settings.state.theme == Theme.DARK }
            window.press(KeyEvent.VK_SPACE)
            window.awaitState("the cursor to run") { it.player.state.isPlaying }
            window.look { it.settings.state.theme } shouldBe Theme.DARK
            window.press(KeyEvent.VK_SPACE)
            window.awaitState("the cursor to stand") { !it.player.state.isPlaying }

            val graphs = window.look { it.board.state.graphs.size }
            window.click("Topic Arm/Angle")
            window.awaitState("another number of graphs") { it.board.state.graphs.size != graphs }
            val clicked = window.look { it.board.state.graphs.size }
            window.press(KeyEvent.VK_SPACE)
            window.awaitState("the cursor to run") { it.player.state.isPlaying }
            window.look { it.board.state.graphs.size } shouldBe clicked
        }
    }

    test("each key has the effect that the sheet lists, except while a person types").config(enabledOrReasonIf = { needsDisplay }) {
        open().use { window ->
            val all = window.look { it.view.viewport.full }
            window.press(KeyEvent.VK_RIGHT)
            window.awaitState("a cursor") { it.view.cursor != null }
            val cursor = window.look { it.view.cursor }.shouldNotBeNull()
            window.press(KeyEvent.VK_RIGHT, KeyEvent.VK_SHIFT)
            window.awaitState("the cursor further on") { (it.view.cursor ?: 0.0) > cursor + 0.15 }
            fun awaitWidth(what: String, width: Double) = window.awaitState(what) { abs(it.view.viewport.visible.width - width) < 1e-6 }
            window.press(KeyEvent.VK_EQUALS)
            window.press(KeyEvent.VK_EQUALS, KeyEvent.VK_SHIFT)
            awaitWidth("a closer look", all.width / 2.25)
            window.press(KeyEvent.VK_MINUS)
            awaitWidth("a wider look", all.width / 1.5)
            window.press(KeyEvent.VK_0)
            awaitWidth("everything", all.width)
            window.press(KeyEvent.VK_E)
            window.awaitState("the time enabled") { it.view.viewport.visible.width < all.width }
            window.press(KeyEvent.VK_BACK_SPACE)
            awaitWidth("everything again", all.width)

            window.press(KeyEvent.VK_PAGE_DOWN)
            window.awaitState("another log") { it.current.recording?.file?.fileName.toString() != "qualification-42.bag" }
            window.press(KeyEvent.VK_PAGE_UP)
            window.awaitState("the first log") { it.current.recording?.file?.fileName.toString() == "qualification-42.bag" }

            window.press(KeyEvent.VK_SLASH)
            window.type("test 57 0e")
            window.awaitState("a filter") { it.library.state.listing.filter == "test 57 0e" }
            window.look { it.view.viewport.visible } shouldBe all
            window.look { it.player.state.isPlaying } shouldBe false
            window.look { it.panels.state.main.name } shouldBe "GRAPHS"
            window.press(KeyEvent.VK_ESCAPE)
            window.awaitState("no filter") { it.library.state.listing.filter.isEmpty() }
            window.press(KeyEvent.VK_E)
            window.awaitState("the time enabled") { it.view.viewport.visible.width < all.width }

            window.click("Search topics")
            window.type("0")
            window.awaitState("a search") { it.topics.state.query == "0" }
            window.look { it.view.viewport.visible.width < all.width } shouldBe true
            window.click("Plot Match Time")
            window.press(KeyEvent.VK_0)
            window.awaitState("everything again") { it.view.viewport.visible == all }
            window.look { it.topics.state.query } shouldBe "0"

            window.press(KeyEvent.VK_SLASH)
            window.type("practice")
            window.awaitState("a filter") { it.library.state.listing.filter == "practice" }
            window.press(KeyEvent.VK_ENTER)
            window.awaitState("the log that was searched") { it.current.recording?.file?.fileName.toString() == "practice.bag" }
            window.press(KeyEvent.VK_SPACE)
            window.awaitState("the cursor to run") { it.player.state.isPlaying }
        }
    }

    test("a click on an event goes there, and a search finds topics").config(enabledOrReasonIf = { needsDisplay }) {
        open().use { window ->
            window.press(KeyEvent.VK_1, KeyEvent.VK_CONTROL)
            window.awaitState("the events") { it.panels.state.inspector == InspectorTab.EVENTS }
            val event = window.look { it.events.matching.textOf(it.events.matching.size / 2) }
            window.click("Search events")
            window.type(event.take(4).lowercase())
            window.awaitState("the search") { it.events.state.text == event.take(4).lowercase() }
            window.click(event)
            window.awaitState("the cursor at an event") { viewer ->
                viewer.view.cursor?.let { cursor -> viewer.events.matching.x.any { it == cursor } } == true
            }
            window.awaitNo("Search topics")
            window.press(KeyEvent.VK_F, KeyEvent.VK_CONTROL)
            window.awaitText("Search topics")
            window.type("voltage")
            window.awaitText("Topic System/Battery Voltage")
            window.press(KeyEvent.VK_2, KeyEvent.VK_CONTROL)
            window.awaitState("the metadata") { it.panels.state.inspector == InspectorTab.VALUES }
            window.press(KeyEvent.VK_1, KeyEvent.VK_CONTROL)
            window.awaitState("the events") { it.panels.state.inspector == InspectorTab.EVENTS }
            window.look { it.topics.state.query } shouldBe "voltage"
            window.awaitGraphs()
            window.picture("events-and-topics")
            val before = window.look { viewer -> viewer.board.state.graphs.sumOf { it.lines.size } }
            window.dragTo("Topic System/Battery Voltage", "Plot Match Time") { viewer -> viewer.board.state.graphs.sumOf { it.lines.size } == before + 1 }
        }
    }
})
