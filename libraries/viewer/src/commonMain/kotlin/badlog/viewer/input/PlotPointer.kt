package badlog.viewer.input

/** A pressed button of a mouse. */
enum class PointerButton { LEFT, MIDDLE, RIGHT }

/**
 * A pointer on the frame of a plot, or beside it, as a front end reports it. Lengths are in CSS pixels or dp.
 *
 * @property x the distance from the frame's left edge.
 * @property y the distance from the frame's top.
 * @property width the width of the frame.
 * @property height the height of the frame.
 * @property millis the time of any clock, in ms.
 * @property ctrl whether Ctrl is held, or the command key on a Mac.
 * @property button the pressed button of a mouse.
 * @property finger distinguishes fingers; null for a mouse.
 */
class PlotPointer(
    val x: Double,
    val y: Double,
    val width: Double,
    val height: Double,
    val millis: Double,
    val shift: Boolean = false,
    val alt: Boolean = false,
    val ctrl: Boolean = false,
    val button: PointerButton = PointerButton.LEFT,
    val finger: Int? = null,
) {
    /** The x of the pointer as a fraction of the width, from the left. */
    val shareX: Double get() = x / width

    /** The y of the pointer as a fraction of the height, from the top. */
    val shareY: Double get() = y / height
}
