package badlog.viewer.choices.board

import badlog.core.analysis.Span

/**
 * The visible part of a plane.
 *
 * @property x the range from left to right.
 * @property y the range from bottom to top.
 */
data class Plane(val x: Span, val y: Span) {
    /** Returns this plane, extended so that x and y have the same scale on [width] by [height] pixels. */
    fun fitted(width: Double, height: Double): Plane {
        val pixel = maxOf(x.width / width, y.width / height)
        return Plane(around(x, pixel * width), around(y, pixel * height))
    }

    /** Returns the plane scaled by [factor], with ([atX], [atY]) staying in place. */
    fun scaled(factor: Double, atX: Double, atY: Double): Plane = Plane(scaled(x, factor, atX), scaled(y, factor, atY))

    /** Returns the plane moved by [right] to the right and [up] upwards. */
    fun shifted(right: Double, up: Double): Plane = Plane(Span(x.from + right, x.to + right), Span(y.from + up, y.to + up))

    /** Returns the part between two points, given as fractions of the width from the left and of the height from the top. */
    fun part(oneX: Double, oneY: Double, otherX: Double, otherY: Double): Plane =
        Plane(Span(xAt(minOf(oneX, otherX)), xAt(maxOf(oneX, otherX))), Span(yAt(maxOf(oneY, otherY)), yAt(minOf(oneY, otherY))))

    /** Returns the x at this [share] of the width, from the left. */
    fun xAt(share: Double): Double = x.from + share * x.width

    /** Returns the y at this [share] of the height, from the top. */
    fun yAt(share: Double): Double = y.to - share * y.width

    /** Returns the box of [other] on [width] by [height] pixels that show this plane: left, top, width and height. */
    fun boxOf(other: Plane, width: Double, height: Double): DoubleArray = doubleArrayOf(
        (other.x.from - x.from) / x.width * width,
        (y.to - other.y.to) / y.width * height,
        other.x.width / x.width * width,
        other.y.width / y.width * height,
    )

    /** Whether doubles are precise enough to draw this plane. */
    val isDrawable: Boolean get() = isDrawable(x) && isDrawable(y)

    private fun around(span: Span, width: Double): Span {
        val middle = (span.from + span.to) / 2
        return Span(middle - width / 2, middle + width / 2)
    }

    private fun scaled(span: Span, factor: Double, at: Double) = Span(at + (span.from - at) * factor, at + (span.to - at) * factor)

    private fun isDrawable(span: Span) = span.width > FINEST * maxOf(1.0, span.from, -span.from) && span.width < COARSEST
}

/**
 * The origin from which a log's poses are measured. It is the corner at the right end of an alliance's wall, or the center of the field.
 *
 * @property label the name in a menu.
 */
enum class FieldOrigin(val label: String) {
    /** The blue alliance's wall, as in WPILib. */
    BLUE("Blue origin"),

    /** The red alliance's wall. */
    RED("Red origin"),

    /** The wall of the robot's own alliance in each match; the blue wall if the log does not name the alliance. */
    AUTO("Auto origin"),

    /** The center of the field as seen from the red alliance's wall: x points towards the blue wall. */
    CENTER("Center origin"),
    ;

    internal val key: String get() = name.lowercase()

    internal companion object {
        fun of(key: String?): FieldOrigin? = entries.find { it.key == key }
    }
}

private const val FINEST = 1e-9
private const val COARSEST = 1e12
