package badlog.viewer.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.analysis.Span
import badlog.plot.range.Viewport
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
class OverviewSpec : FunSpec({
    val zoomed = Viewport(Span(0.0, 100.0)).showing(40.0, 60.0)

    test("the edges of what is visible can be taken, its middle, and what is beside it") {
        gripAt(40.5, zoomed, 1.0) shouldBe OverviewGrip.LEFT
        gripAt(60.5, zoomed, 1.0) shouldBe OverviewGrip.RIGHT
        gripAt(50.0, zoomed, 1.0) shouldBe OverviewGrip.WINDOW
        gripAt(80.0, zoomed, 1.0) shouldBe OverviewGrip.NEW
        gripAt(50.0, zoomed.reset(), 1.0) shouldBe OverviewGrip.NEW
    }

    test("a narrow window has a middle too") {
        gripAt(50.0, Viewport(Span(0.0, 100.0)).showing(49.9, 50.1), 5.0) shouldBe OverviewGrip.WINDOW
    }

    test("an edge moves alone, and stops at the other") {
        zoomed.overviewDragged(OverviewGrip.LEFT, zoomed.visible, 40.0, 30.0).visible shouldBe Span(30.0, 60.0)
        zoomed.overviewDragged(OverviewGrip.RIGHT, zoomed.visible, 60.0, 10.0).visible.from shouldBe (40.0 plusOrMinus 1e-3)
    }

    test("the window moves as a whole") {
        zoomed.overviewDragged(OverviewGrip.WINDOW, zoomed.visible, 50.0, 70.0).visible shouldBe Span(60.0, 80.0)
    }

    test("a battery's voltage is chosen, or else the first numbers") {
        overviewSpec(sample("qualification-42.bag"))?.title shouldBe "System/Battery Voltage"
        overviewSpec(recordingOf(bagOf(3) { 1.0 }))?.title shouldBe "A/Voltage"
        overviewSpec(recordingOf("")) shouldBe null
    }

    test("a drag over the overview of everything chooses what is seen") {
        val viewer = viewerOf(recordingOf(bagOf(1001) { it * 1.0 }))
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            onNodeWithContentDescription("Overview").performMouseInput {
                moveTo(Offset(width * 0.2f, centerY))
                press()
                moveTo(Offset(width * 0.3f, centerY))
                moveTo(Offset(width * 0.5f, centerY))
                release()
            }
            viewer.viewport.visible.from shouldBe (20.0 plusOrMinus 0.3)
            viewer.viewport.visible.to shouldBe (50.0 plusOrMinus 0.3)
            viewer.viewport.back().isZoomed shouldBe false
        }
    }
})
