package badlog.window.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.choices.board.Board
import badlog.window.app.Viewer
import badlog.window.bagOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
class GraphDragSpec : FunSpec({
    val recording by lazy { recordingOf(bagOf(listOf("Time|xaxis", "A", "B", "C"), List(20) { "$it,$it,${it * 2},${it * 3}" })) }
    val three = Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C"))

    fun lines(viewer: Viewer) = viewer.board.state.graphs.map { it.lines.joinToString("+") }

    fun graphs(test: DesktopComposeUiTest.(Viewer) -> Unit) = runDesktopComposeUiTest(900, 600) {
        val viewer = viewerOf(recording)
        viewer.board.replace(three)
        setContent { TestGraphs(viewer) }
        waitForPictures(viewer)
        test(viewer)
    }

    /** Drags graph [dragged] by its title to the [share] of the height of graph [onto]. */
    fun DesktopComposeUiTest.take(dragged: String, onto: String, share: Float) {
        val from = onNodeWithContentDescription("Graph $dragged").fetchSemanticsNode().boundsInRoot
        val to = onNodeWithContentDescription("Graph $onto").fetchSemanticsNode().boundsInRoot
        onRoot().performMouseInput {
            moveTo(from.topLeft + Offset(14f, 10f))
            press()
            moveTo(from.topLeft + Offset(30f, 14f))
            moveTo(Offset(60f, to.top + to.height * share))
        }
    }

    fun DesktopComposeUiTest.letGo() {
        onRoot().performMouseInput { release() }
        waitForIdle()
    }

    test("a graph dragged by its title is moved above, below or into another one, and undo moves it back") {
        graphs { viewer ->
            take("C", "A", 0.1f)
            savePicture("graph-dragged-above")
            letGo()
            lines(viewer) shouldContainExactly listOf("C", "A", "B")
            take("C", "B", 0.9f)
            letGo()
            lines(viewer) shouldContainExactly listOf("A", "B", "C")
            take("B", "A", 0.5f)
            savePicture("graph-dragged-into")
            letGo()
            lines(viewer) shouldContainExactly listOf("A+B", "C")
            viewer.board.undo()
            lines(viewer) shouldContainExactly listOf("A", "B", "C")
        }
    }

    test("Escape, and a drop at the old place, leave a dragged graph there") {
        graphs { viewer ->
            take("C", "A", 0.1f)
            viewer.keyboard.menus.closeLast() shouldBe true
            letGo()
            lines(viewer) shouldContainExactly listOf("A", "B", "C")
            take("B", "B", 0.5f)
            letGo()
            lines(viewer) shouldContainExactly listOf("A", "B", "C")
        }
    }

    test("a drag over a plot zooms, and does not move the graph") {
        graphs { viewer ->
            onNodeWithContentDescription("Plot C").performMouseInput {
                moveTo(Offset(width * 0.2f, centerY))
                press()
                moveTo(Offset(width * 0.5f, centerY))
                moveTo(Offset(width * 0.8f, centerY - 300))
                release()
            }
            waitForIdle()
            viewer.view.viewport.isZoomed shouldBe true
            viewer.board.state shouldBe three
        }
    }
})
