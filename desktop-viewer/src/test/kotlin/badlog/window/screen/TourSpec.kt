package badlog.window.screen

import badlog.catalog.folder.putSamples
import badlog.viewer.shown.folder.foundText
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.math.abs

/** The moving picture of the window. A person with a mouse goes from a folder of logs to the cause of a failed match. */
@Tags("InCheck")
class TourSpec : FunSpec({
    test("one click leads from the table of logs to the brownout, which is looked at closely and compared with another match").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val film = Film(Path.of("build/tour"))
        val folder = Files.createDirectories(tempdir().toPath().resolve("Mill Creek")).also { it.putSamples(areSettled = true) }
        RealWindow(tempdir().toPath(), folder, WIDTH, HEIGHT).use { window ->
            fun show(millis: Int) = film.add(window, millis)
            window.awaitState("all logs, and one of them") { it.library.state.entries.size == 4 && it.current.recording != null }
            // Fewer parts, as they would be too small in a picture.
            window.click("Topics")
            window.press(KeyEvent.VK_T)
            window.awaitState("what the rules found") { viewer -> viewer.library.state.entries.all { it.found != null || it.isGray } }
            val happened = window.look { viewer ->
                viewer.library.state.entries.first { it.fileName == "qualification-42.bag" }.let { "error: ${foundText(it)} · Log ${it.fileName}" }
            }
            window.awaitRest(happened)
            window.point(happened, 0.5, 0.6)
            show(1800)
            window.click(happened)
            window.awaitState("the match, and the worst that was found in it") { viewer ->
                viewer.current.recording?.file?.fileName.toString() == "qualification-42.bag" && viewer.findings.selected != null
            }
            window.awaitState("what shows it, all on the screen") { viewer ->
                viewer.board.evidence.graphs.isNotEmpty() && viewer.board.inSight.orEmpty().containsAll(viewer.board.evidence.graphs.map { it.id })
            }
            window.look { viewer -> viewer.board.evidence.graphs.flatMap { it.lines } } shouldContainAll
                listOf("System/Battery Voltage", "PDP/Total Current", "Drivetrain/Left Output")
            window.look { viewer -> 93.7096 in viewer.view.viewport.visible } shouldBe true
            window.look { viewer -> viewer.panels.state.inspector } shouldBe InspectorTab.FINDINGS
            window.awaitState("the graphs") { it.panels.state.main == MainView.GRAPHS }
            window.awaitGraphs()
            val first = checkNotNull(window.look { it.view.cursor })
            show(2200)

            val plot = "Plot System/Battery Voltage"
            for (x in listOf(0.36, 0.42, 0.48, 0.54)) {
                window.point(plot, x, 0.5)
                show(350)
            }
            val before = window.look { it.view.viewport.visible.width }
            repeat(3) {
                window.wheel(-1, KeyEvent.VK_CONTROL)
                window.awaitGraphs()
                show(350)
            }
            window.awaitState("a closer look") { it.view.viewport.visible.width < before }
            window.press(KeyEvent.VK_N)
            window.awaitState("the next finding") { viewer -> viewer.view.cursor?.let { abs(it - first) > 1e-3 } == true }
            window.awaitGraphs()
            show(1800)

            window.press(KeyEvent.VK_5, KeyEvent.VK_CONTROL)
            window.press(KeyEvent.VK_0)
            window.awaitState("all of the match") { it.panels.state.inspector == null && it.view.viewport.visible == it.view.viewport.full }
            window.awaitGraphs()
            show(1200)
            window.click("Compare qualification-57.bag.gz")
            window.click("Compare qualification-42.bag")
            window.awaitState("two logs") { it.compared.drawn.size == 2 }
            window.awaitGraphs()
            show(2500)
        }
    }
})

/** Pictures of a window in [folder], one after the other, and no other files. Only the task `tour` takes them, see build.gradle. */
private class Film(private val folder: Path) {
    private val isTaken = System.getenv("BADLOG_TOUR") != null
    private var count = 0

    init {
        if (isTaken) {
            folder.toFile().deleteRecursively()
            Files.createDirectories(folder)
        }
    }

    /** Adds the current picture of [window], to be shown for [millis] milliseconds. */
    fun add(window: RealWindow, millis: Int) {
        if (!isTaken) return
        val name = "%02d-%d.png".format(count++, millis)
        ImageIO.write(window.captureWithPointer(), "png", folder.resolve(name).toFile())
    }
}

private const val WIDTH = 1280
private const val HEIGHT = 760
