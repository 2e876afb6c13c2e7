package badlog.window.charts

import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.putSamples
import badlog.files.UserFolders
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.files.ChosenFiles
import badlog.window.sidebar.MainView
import badlog.window.waiting.waitFor
import badlog.window.waiting.waitForNotice
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO

/** The charts of a folder’s logs, as a person sees them. */
@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class ChartsPaneSpec : FunSpec({
    val chosen = ChosenFiles(null)

    fun onFolder(folder: Path, steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home), files = chosen)
        runDesktopComposeUiTest(1400, 900) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.newest.run() }
            viewer.library.open(folder)
            waitFor { viewer.library.state.hasLooked && viewer.library.state.entries.let { all -> all.isNotEmpty() && all.all { it.found != null || it.isGray } } }
            try {
                steps(viewer)
            } finally {
                viewer.library.close()
            }
        }
    }

    fun sampleFolder() = tempdir().toPath().also { it.putSamples(areSettled = true) }

    /** Presses the key that shows the charts. */
    fun showCharts(viewer: Viewer) = viewer.commands.first { it.meaning == "Show or hide charts of the listed logs" }.action()

    fun names(viewer: Viewer) = viewer.charts.state.charts?.all.orEmpty().map { it.name }

    test("a key shows charts of the listed logs and the data that others lack, which can be saved; shown again, they are not redrawn") {
        val target = tempdir().toPath()
        onFolder(sampleFolder()) { viewer ->
            showCharts(viewer)
            waitFor { names(viewer).isNotEmpty() }
            names(viewer).take(2) shouldContainExactly listOf("battery", "loop-times")
            onNodeWithContentDescription("Battery at its lowest. How is the battery doing", substring = true).assertExists()
            viewer.charts.state.charts!!.lacking.first() shouldStartWith "“Packet loss” needs"
            chosen.file = target.resolve("battery.svg")
            onNodeWithContentDescription("Save “Battery at its lowest” as SVG").performClick()
            waitForNotice(viewer, "Saved the chart to ${chosen.file}.")
            Files.readString(target.resolve("battery.svg")) shouldStartWith "<svg"
            chosen.file = target.resolve("battery.png")
            onNodeWithContentDescription("Save “Battery at its lowest” as PNG").performClick()
            waitForNotice(viewer, "Saved the chart to ${chosen.file}.")
            ImageIO.read(target.resolve("battery.png").toFile()).width shouldBeGreaterThan 900
            showCharts(viewer)
            viewer.panels.state.main shouldBe MainView.GRAPHS
            val drawn = viewer.charts.state.charts
            showCharts(viewer)
            waitForIdle()
            viewer.charts.state.run { (charts === drawn) to isDrawing } shouldBe (true to false)
        }
    }
})
