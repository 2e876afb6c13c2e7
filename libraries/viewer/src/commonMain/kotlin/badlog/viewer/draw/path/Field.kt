package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.signals.pose.Trail
import badlog.viewer.choices.board.Plane

/**
 * The field with its outline and center line. Places are in meters from the corner at the right end of the blue alliance's wall.
 *
 * @property length the length, from the blue alliance's wall to the red one's.
 * @property width the width.
 * @property image the picture; null if there is none.
 */
class Field(val length: Double = LENGTH, val width: Double = WIDTH, val image: FieldImage? = null) {
    /** Returns the whole field, with the surroundings if [trails] leave it. */
    internal fun around(trails: List<Trail>): Plane {
        fun spanOf(length: Double, spans: List<Span?>) = Span(
            minOf(0.0, spans.minOfOrNull { it?.from ?: 0.0 } ?: 0.0).coerceAtLeast(-length) - MARGIN,
            maxOf(length, spans.maxOfOrNull { it?.to ?: 0.0 } ?: 0.0).coerceAtMost(2 * length) + MARGIN,
        )
        return Plane(spanOf(length, trails.map { it.xSpan }), spanOf(width, trails.map { it.ySpan }))
    }

    /** Returns this field with [source] as the source of its picture. */
    internal fun withPicture(source: String): Field =
        Field(length, width, checkNotNull(image).run { FieldImage(source, left, top, right, bottom) })

    companion object {
        /** The length in 2026, from WPILib's AprilTag layout. */
        const val LENGTH: Double = 16.541

        /** The width in 2026. */
        const val WIDTH: Double = 8.069

        /** A field without a picture. */
        val PLAIN: Field = Field()
        private const val MARGIN = 0.3
    }
}

/**
 * The picture of a field, seen from above with the blue alliance at the left.
 *
 * @property source the name of the picture's file, or the whole picture as a data URL.
 * @param left the left edge of the field in the picture, in pixels; [top], [right] and [bottom] likewise.
 */
class FieldImage internal constructor(
    val source: String,
    internal val left: Double,
    internal val top: Double,
    internal val right: Double,
    internal val bottom: Double,
) {
    /**
     * Returns the plane that the whole picture of [width] by [height] pixels shows; the field's corners in it are the corners of [field].
     */
    fun plane(field: Field, width: Int, height: Int): Plane {
        val across = field.length / (right - left)
        val up = field.width / (bottom - top)
        return Plane(Span(-left * across, (width - left) * across), Span((bottom - height) * up, bottom * up))
    }
}
