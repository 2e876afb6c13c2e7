package badlog.viewer.draw.pen

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import kotlin.math.sin

/** Each primitive of a pen, by name, on a picture of [PRIMITIVE_WIDTH] by [PRIMITIVE_HEIGHT]: the pictures of all pens must agree. */
val PEN_PRIMITIVES: Map<String, Pen.() -> Unit> = mapOf(
    "lines" to { lines(wave(), COLORS.line(0), 1.5) },
    "dashed lines" to { lines(wave(), COLORS.line(1), 2.0, dash = 6.0) },
    "areas" to { areas(wave(), 50.0, faded(COLORS.line(2), 0.4)) },
    "segments" to { segments(Points().line(10.5, 0.0, 10.5, 100.0).line(0.0, 40.5, 200.0, 40.5), COLORS.line(3), 1.0) },
    "a chain" to { chain(Points().outline(), isClosed = true, COLORS.line(4), 3.0) },
    "shapes" to { shapes(Points().outline().add(10.0, 90.0).add(30.0, 90.0).add(20.0, 60.0), corners = 3, COLORS.line(5)) },
    "dots" to { dots(Points().add(50.0, 50.0).add(120.0, 20.0), 6.0, COLORS.line(6)) },
    "a ring" to { ring(100.0, 50.0, 20.0, COLORS.line(7), 3.0) },
    "a rectangle" to { rectangle(20.0, 30.0, 60.5, 25.0, faded(COLORS.line(8), 0.5)) },
    "what is moved and clipped" to {
        moved(30.0, 10.0) { clip(0.0, 0.0, 50.0, 40.0) { dots(Points().add(40.0, 30.0), 20.0, COLORS.line(9)) } }
    },
)

/** The width of a picture with a primitive. */
const val PRIMITIVE_WIDTH: Int = 200

/** The height of a picture with a primitive. */
const val PRIMITIVE_HEIGHT: Int = 100

private val COLORS = PenColors.LIGHT

/** Returns a line over all of a picture, with a gap in its middle. */
private fun wave(): Strokes {
    val y = DoubleArray(PRIMITIVE_WIDTH) { if (it in 90..99) Double.NaN else sin(it / 9.0) }
    val curve = Curve(Series(DoubleArray(PRIMITIVE_WIDTH) { it.toDouble() }, y), holdsUntil = null)
    curve.draw(0.0, PRIMITIVE_WIDTH.toDouble(), PixelColumns(PRIMITIVE_WIDTH))
    return Strokes().apply { trace(curve, Scale(0.0, 200.0, 200.0), Scale(1.0, -1.0, 80.0, start = 10.0)) }
}

private fun Points.outline() = add(150.0, 20.0).add(180.0, 20.0).add(165.0, 50.0)
