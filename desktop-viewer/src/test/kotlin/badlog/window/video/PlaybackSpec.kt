package badlog.window.video

import badlog.core.analysis.Span
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.graph.bagOf
import badlog.window.graph.recordingOf
import badlog.window.graph.viewerOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll

class PlaybackSpec : FunSpec({
    val playing = Playback(isPlaying = true)

    test("the cursor never leaves the played range, and goes back only at the end of a loop") {
        checkAll(Arb.numericDouble(-10.0, 20.0), Arb.numericDouble(0.0, 100.0), Arb.boolean()) { cursor, distance, loops ->
            val step = playing.copy(loops = loops).advanced(cursor, distance, Span(0.0, 10.0))
            (step.cursor in 0.0..10.0) shouldBe true
            if (!loops && cursor in 0.0..10.0) (step.cursor >= cursor) shouldBe true
            step.playback.isPlaying shouldBe (loops || step.cursor < 10.0)
        }
    }

    test("a loop continues from its beginning with the remaining distance") {
        playing.copy(loops = true).advanced(9.0, 3.0, Span(0.0, 10.0)).cursor shouldBe 2.0
    }

    test("two steps are the same as one of both lengths") {
        checkAll(Arb.numericDouble(0.0, 4.0), Arb.numericDouble(0.0, 4.0)) { one, other ->
            val range = Span(0.0, 10.0)
            val first = playing.advanced(1.0, one, range)
            first.playback.advanced(first.cursor, other, range).cursor shouldBe
                (playing.advanced(1.0, one + other, range).cursor plusOrMinus 1e-9)
        }
    }

    test("the view follows a cursor that leaves it, without filling the history") {
        val viewer = viewerOf(recordingOf(bagOf(1001) { 0.0 }))
        viewer.view.send(PlaceAction.Show(0.0, 10.0))
        viewer.view.send(PlaceAction.MoveCursor(9.9))
        viewer.player.toggle()
        viewer.player.advance(0.2)
        viewer.view.cursor.shouldNotBeNull() shouldBe (10.1 plusOrMinus 1e-9)
        (viewer.view.cursor.shouldNotBeNull() in viewer.view.viewport.visible) shouldBe true
        viewer.view.press(KeyAction.PREVIOUS_VIEW)
        viewer.view.viewport.isZoomed shouldBe false
    }

    test("playback at the end starts over") {
        val viewer = viewerOf(recordingOf(bagOf(101) { 0.0 }))
        viewer.view.send(PlaceAction.MoveCursor(10.0))
        viewer.player.toggle()
        viewer.view.cursor shouldBe 0.0
        viewer.player.state.isPlaying shouldBe true
    }

    test("a selection is the played range") {
        val viewer = viewerOf(recordingOf(bagOf(101) { 0.0 }))
        viewer.view.send(PlaceAction.Select(Span(2.0, 2.1)))
        viewer.player.change { Playback(loops = true) }
        viewer.player.toggle()
        repeat(20) {
            viewer.player.advance(0.03)
            (viewer.view.cursor.shouldNotBeNull() in Span(2.0, 2.1)) shouldBe true
        }
    }
})
