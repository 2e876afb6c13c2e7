package badlog.viewer.graph

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.analysis.Span
import badlog.viewer.theme.Theme
import io.kotest.core.spec.style.FunSpec

/** Pictures for a person to look at, under `build/pictures`; the tests only tell that they can be made. */
@OptIn(ExperimentalTestApi::class)
class GraphPicturesSpec : FunSpec({
    test("a match in light colours") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        viewer.cursor = 93.7
        runDesktopComposeUiTest(1100, 860) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            savePicture("graphs-light")
        }
    }

    test("the middle of a match in dark colours, with a selection and two axes") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        val names = listOf("System/Battery Voltage", "PDP/Total Current", "Drivetrain/Gear")
        viewer.graphs = GraphList().withGraph(names).withGraph(names.take(1)).withGraph(listOf("Elevator/Position"))
        viewer.viewport = viewer.viewport.showing(85.0, 102.0)
        viewer.cursor = 93.7
        viewer.isCursorPinned = true
        viewer.selection = Span(92.0, 97.2)
        runDesktopComposeUiTest(1100, 860) {
            setContent { TestGraphs(viewer, Theme.DARK) }
            waitForPictures(viewer)
            savePicture("graphs-dark")
        }
    }

    test("a narrow window") {
        val viewer = viewerOf(sample("practice.bag"))
        runDesktopComposeUiTest(380, 700) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            savePicture("graphs-narrow")
        }
    }
})
