package badlog.window.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.MouseButton
import androidx.compose.ui.test.ScrollWheel
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performMultiModalInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.window.app.Viewer
import badlog.window.log.OpenRecording
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.sin

@OptIn(ExperimentalTestApi::class)
class PlotGesturesSpec : FunSpec({
    val recording: OpenRecording by lazy { recordingOf(bagOf(1001) { 10 + sin(it / 50.0) }) }

    /** Runs [test] over a graph of 100 s. */
    fun graph(test: DesktopComposeUiTest.(Viewer) -> Unit) = runDesktopComposeUiTest(900, 600) {
        val viewer = viewerOf(recording)
        setContent { TestGraphs(viewer) }
        waitForPictures(viewer)
        test(viewer)
    }

    fun DesktopComposeUiTest.plot() = onNodeWithContentDescription("Plot A/Voltage")

    test("the wheel with Ctrl zooms around the pointer; without Ctrl, and over the title, it scrolls the list") {
        graph { viewer ->
            onNodeWithContentDescription("Graph A/Voltage").performMouseInput {
                moveTo(Offset(200f, 8f))
                scroll(-3f, ScrollWheel.Vertical)
            }
            plot().performMouseInput {
                moveTo(Offset(width * 0.25f, centerY))
                scroll(-3f, ScrollWheel.Vertical)
            }
            viewer.view.viewport.isZoomed shouldBe false
            plot().performMultiModalInput {
                key { keyDown(Key.CtrlLeft) }
                mouse {
                    moveTo(Offset(width * 0.25f, centerY))
                    scroll(-3f, ScrollWheel.Vertical)
                }
                key { keyUp(Key.CtrlLeft) }
            }
            val visible = viewer.view.viewport.visible
            visible.width shouldBeLessThan 65.0
            (25.0 - visible.from) / visible.width shouldBe (0.25 plusOrMinus 0.002)
        }
    }

    test("a drag shows its range, and a double click everything") {
        graph { viewer ->
            plot().performMouseInput {
                moveTo(Offset(width * 0.2f, centerY))
                press()
                moveTo(Offset(width * 0.4f, centerY))
            }
            viewer.view.viewport.isZoomed shouldBe false
            plot().performMouseInput { release() }
            viewer.view.viewport.visible.from shouldBe (20.0 plusOrMinus 0.2)
            viewer.view.viewport.visible.to shouldBe (40.0 plusOrMinus 0.2)
            plot().performMouseInput { doubleClick() }
            viewer.view.viewport.visible shouldBe viewer.view.viewport.full
            viewer.view.isCursorPinned shouldBe false
        }
    }

    test("a drag with Alt shows a part of its graph's y, until it is reset") {
        graph { viewer ->
            plot().performMultiModalInput {
                key { keyDown(Key.AltLeft) }
                mouse {
                    moveTo(Offset(centerX, height * 0.5f))
                    press()
                    moveTo(Offset(centerX, height * 0.25f))
                    release()
                }
                key { keyUp(Key.AltLeft) }
            }
            val range = viewer.board.state.graphs.single().yRange.shouldNotBeNull()
            range.from shouldBe (10.0 plusOrMinus 0.02)
            range.to shouldBe (10.57 plusOrMinus 0.03)
            viewer.view.viewport.isZoomed shouldBe false
            waitForIdle()
            onNodeWithContentDescription("Reset Y zoom").performClick()
            viewer.board.state.graphs.single().yRange.shouldBeNull()
        }
    }

    test("a drag with the other button selects a range, which can be zoomed to and cleared") {
        graph { viewer ->
            plot().performMouseInput {
                moveTo(Offset(width * 0.5f, centerY))
                press(MouseButton.Secondary)
                moveTo(Offset(width * 0.6f, centerY))
                release(MouseButton.Secondary)
            }
            val selection = viewer.view.selection.shouldNotBeNull()
            selection.from shouldBe (50.0 plusOrMinus 0.2)
            selection.to shouldBe (60.0 plusOrMinus 0.2)
            viewer.view.viewport.isZoomed shouldBe false
            waitForIdle()
            onNodeWithContentDescription("Zoom to the selection (Z)").performClick()
            viewer.view.viewport.visible shouldBe selection
            onNodeWithContentDescription("Clear the selection (Escape)").performClick()
            viewer.view.selection.shouldBeNull()
        }
    }

    test("two fingers zoom into the range between them") {
        graph { viewer ->
            plot().performTouchInput {
                down(0, Offset(width * 0.4f, centerY))
                down(1, Offset(width * 0.6f, centerY))
                moveTo(0, Offset(width * 0.2f, centerY))
                moveTo(1, Offset(width * 0.8f, centerY))
                up(0)
                up(1)
            }
            viewer.view.viewport.visible.from shouldBe (100.0 / 3 plusOrMinus 0.3)
            viewer.view.viewport.visible.to shouldBe (200.0 / 3 plusOrMinus 0.3)
            viewer.view.isCursorPinned shouldBe false
        }
    }
})
