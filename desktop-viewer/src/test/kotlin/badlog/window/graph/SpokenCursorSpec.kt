package badlog.window.graph

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.bagOf
import badlog.window.change
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SpokenCursorSpec : FunSpec({
    val rows = List(11) { "$it,${12 - it},${it * 2}" }
    val log = recordingOf(bagOf(listOf("Time|xaxis", "Voltage", "Current"), rows))

    fun viewer() = viewerOf(log).apply { board.replace(Board(listOf(BoardGraph(1, "Battery", listOf("Voltage", "Current"))))) }

    test("the text for screen readers is about the cursor that keys move, without the values of hidden lines") {
        val viewer = viewer()
        viewer.board.change { withLineHidden(1, "Voltage", true) }
        viewer.view.send(PlaceAction.MoveCursor(4.0))
        viewer.view.press(KeyAction.SECOND_CURSOR)
        viewer.view.press(KeyAction.NEXT_SAMPLE)
        viewer.spoken.state shouldBe "5.000 V, Current 10 V"
    }

    test("the text for screen readers has a finding with its place") {
        val viewer = viewer()
        viewer.view.send(PlaceAction.GoTo(3.0))
        viewer.spoken.sayFinding("Browned out")
        viewer.spoken.state shouldBe "3.000 V: Browned out"
    }
})
