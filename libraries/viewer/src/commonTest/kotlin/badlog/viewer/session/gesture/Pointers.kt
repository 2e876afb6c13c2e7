package badlog.viewer.session.gesture

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.PlotPointer
import badlog.viewer.input.PointerButton
import badlog.viewer.state.Place

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

/** A log from 0 to 100, of which a person sees [visible]. */
internal class TestPlot(visible: Span = Span(0.0, 100.0), override val lineShare: Double = 1.0) : PlotTarget {
    override var place = Place(Viewport(Span(0.0, 100.0)).moved(visible.from, visible.to))
    override var drag: PlotDrag? = null
    override var isCursorLed = false

    /** The parts of y that were asked for. */
    val parts = ArrayList<Span?>()
    val visible get() = place.range.visible

    override fun go(step: Place.() -> Place) {
        place = place.step()
    }

    override fun showY(part: Span?) {
        parts += part
    }
}

/** Presses at the first of [places], goes to the others, and releases at the last. */
internal fun Gestures.stroke(vararg places: PlotPointer) {
    press(places.first())
    for (at in places.drop(1)) move(at)
    release(places.last())
}
