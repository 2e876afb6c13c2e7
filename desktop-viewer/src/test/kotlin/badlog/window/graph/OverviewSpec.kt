package badlog.window.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.input.KeyAction
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
class OverviewSpec : FunSpec({
    test("the overview prefers the battery's voltage to the first numbers") {
        overviewSpec(sample("qualification-42.bag"))?.title shouldBe "System/Battery Voltage"
        overviewSpec(recordingOf(bagOf(3) { 1.0 }))?.title shouldBe "A/Voltage"
        overviewSpec(recordingOf("")) shouldBe null
    }

    test("a drag over the overview selects the visible range while everything is visible") {
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
            viewer.view.viewport.visible.from shouldBe (20.0 plusOrMinus 0.3)
            viewer.view.viewport.visible.to shouldBe (50.0 plusOrMinus 0.3)
            viewer.view.press(KeyAction.PREVIOUS_VIEW)
            viewer.view.viewport.isZoomed shouldBe false
        }
    }
})
