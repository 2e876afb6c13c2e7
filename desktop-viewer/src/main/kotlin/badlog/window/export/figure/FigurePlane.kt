package badlog.window.export.figure

import badlog.core.analysis.Span
import badlog.viewer.draw.path.Field
import badlog.viewer.draw.path.Plane

/**
 * The x axis of a frame that has one of its own, and what is on the plane besides the frame's lines.
 *
 * @property x the part of it that it shows.
 * @property xTitle the text below it.
 * @property field the field that it is, whose meters are as long along x as along y; null for another plane.
 * @property picture the picture of the field, below all else; null for none.
 * @property shapes what is drawn above the lines, such as the robot at the cursor, in drawing order.
 * @property labels the texts above those.
 */
internal class FigurePlane(
    val x: Span,
    val xTitle: String,
    val field: Field?,
    val picture: FigurePicture? = null,
    val shapes: List<FigureShape> = emptyList(),
    val labels: List<FigureLabel> = emptyList(),
) {
    val isField: Boolean get() = this.field != null
}

/** A picture, all of it as a data URL in [source], over [plane]. */
internal class FigurePicture(val source: String, val plane: Plane)

/**
 * Lines between places of a [FigurePlane], or a dot.
 *
 * @property places alternating x and y; a single place is a dot.
 * @property color its color, as `#rrggbb`.
 * @property isFilled whether its inside is filled.
 * @property isRing whether the dot is a ring.
 */
internal class FigureShape(
    private val places: DoubleArray,
    val color: String,
    isClosed: Boolean = false,
    val isFilled: Boolean = false,
    val isRing: Boolean = false,
) {
    private val order = places.indices.step(2) + if (isClosed) listOf(0) else emptyList()

    /** Its places as columns, closed where it is. */
    val columns: Map<String, List<Double>> get() = mapOf("x" to order.map { places[it] }, "y" to order.map { places[it + 1] })

    val isDot: Boolean get() = places.size == 2
}

/**
 * A text at a place of a [FigurePlane].
 *
 * @property isLeft whether it extends to the left of [x], rather than to the right.
 * @property isAbove whether it is above [y], rather than below.
 * @property color as `#rrggbb`.
 */
internal class FigureLabel(val text: String, val x: Double, val y: Double, val isLeft: Boolean, val isAbove: Boolean, val color: String)
