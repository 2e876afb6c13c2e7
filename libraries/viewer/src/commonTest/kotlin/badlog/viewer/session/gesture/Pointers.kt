package badlog.viewer.session.gesture

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.PlotPointer
import badlog.viewer.input.PointerButton
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.viewer.state.Shown
import badlog.viewer.state.ViewerState
import badlog.viewer.state.reduce

/** A pointer on a frame of 1000 by 100 pixels. */
internal fun pointer(
    x: Number,
    y: Number = 50,
    millis: Number = 0,
    shift: Boolean = false,
    alt: Boolean = false,
    ctrl: Boolean = false,
    button: PointerButton = PointerButton.LEFT,
    finger: Int? = null,
) = PlotPointer(x.toDouble(), y.toDouble(), 1000.0, 100.0, millis.toDouble(), shift, alt, ctrl, button, finger)

/** A log from 0 to 100 with only [visible] on the screen. */
internal class TestPlot(visible: Span = Span(0.0, 100.0), override val lineShare: Double = 1.0) : PlotTarget {
    override var place = Place(Viewport(Span(0.0, 100.0)).moved(visible.from, visible.to))
    override var drag: PlotDrag? = null
    override var isCursorLed = false

    /** The requested parts of y. */
    val parts = ArrayList<Span?>()
    val visible get() = place.range.visible

    override fun send(action: Action) {
        place = place.after(action)
    }

    override fun showY(part: Span?) {
        parts += part
    }
}

/** Returns the place after [action]. */
internal fun Place.after(action: Action): Place = reduce(ViewerState(this, BoardHistory()), NOTHING, action).state.place

private val NOTHING = object : Shown {
    override val samples = CursorSteps(emptyList())
    override val enabled = emptyList<EnabledSpan>()
    override val found = null
    override val graphs = Board()
}

/** Presses at the first of [places], moves to the others, and releases at the last. */
internal fun Gestures.stroke(vararg places: PlotPointer) {
    press(places.first())
    for (at in places.drop(1)) move(at)
    release(places.last())
}
