package badlog.window.graph

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.state.PlaceAction
import badlog.window.theme.Palette
import badlog.window.theme.Theme
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan

/** Pictures for a person to look at, under `build/pictures`; the tests check that they contain the lines of the graphs. */
@OptIn(ExperimentalTestApi::class)
class GraphPicturesSpec : FunSpec({
    test("a match is drawn in light colors") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        viewer.view.send(PlaceAction.MoveCursor(93.7))
        runDesktopComposeUiTest(1100, 860) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            savePicture("graphs-light").shouldShow(Palette.LIGHT, lines = 1)
        }
    }

    test("the middle of a match is drawn in dark colors, with a selection and two axes") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        val names = listOf("System/Battery Voltage", "PDP/Total Current", "Drivetrain/Gear")
        viewer.board.replace(Board().withGraph(names).withGraph(names.take(1)).withGraph(listOf("Elevator/Position")))
        viewer.view.send(PlaceAction.Show(85.0, 102.0))
        viewer.view.send(PlaceAction.Click(93.7, reach = 0.0, isShifted = false))
        viewer.view.send(PlaceAction.Click(97.0, reach = 0.0, isShifted = true))
        viewer.view.send(PlaceAction.Hover(100.0))
        viewer.view.send(PlaceAction.Select(Span(92.0, 97.2)))
        runDesktopComposeUiTest(1100, 860) {
            setContent { TestGraphs(viewer, Theme.DARK) }
            waitForPictures(viewer)
            savePicture("graphs-dark").shouldShow(Palette.DARK, lines = 2)
        }
    }

    test("graphs are drawn in a narrow window") {
        val viewer = viewerOf(sample("practice.bag"))
        runDesktopComposeUiTest(380, 700) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            savePicture("graphs-narrow").shouldShow(Palette.LIGHT, lines = 1)
        }
    }
})

/** Expects a large area in the [palette]'s background color, and enough pixels of its first [lines] colors to be lines. */
private fun ImageBitmap.shouldShow(palette: Palette, lines: Int) {
    val pixels = toPixelMap().buffer.map { Color(it) }.groupingBy { it }.eachCount()
    pixels.getOrDefault(palette.surface, 0) shouldBeGreaterThan width * height / 5
    for (line in 0 until lines) pixels.getOrDefault(palette.line(line), 0) shouldBeGreaterThan width / 8
}
