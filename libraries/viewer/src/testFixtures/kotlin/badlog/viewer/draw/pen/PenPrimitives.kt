package badlog.viewer.draw.pen

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import kotlin.math.sin

/**
 * Each primitive of a pen, by name, on a picture of [PRIMITIVE_WIDTH] by [PRIMITIVE_HEIGHT]. The pictures of all pens must agree. Each is
 * called with [PRIMITIVE_IMAGE] as the pen's own kind of image. For texts, see [PEN_TEXTS].
 */
val PEN_PRIMITIVES: Map<String, Pen.(PenImage) -> Unit> = mapOf(
    "lines" to { lines(wave(), COLORS.line(0), 1.5) },
    "dashed lines" to { lines(wave(), COLORS.line(1), 2.0, dash = 6.0) },
    "areas" to { areas(wave(), 50.0, faded(COLORS.line(2), 0.4)) },
    "areas beside isolated samples" to { areas(besideSamples(), 50.0, COLORS.line(2)) },
    "segments" to { segments(Points().line(10.5, 0.0, 10.5, 100.0).line(0.0, 40.5, 200.0, 40.5), COLORS.line(3), 1.0) },
    "a chain" to { chain(Points().outline(), isClosed = true, COLORS.line(4), 3.0) },
    "shapes" to { shapes(Points().outline().add(10.0, 90.0).add(30.0, 90.0).add(20.0, 60.0), corners = 3, COLORS.line(5)) },
    "dots" to { dots(Points().add(50.0, 50.0).add(120.0, 20.0), 6.0, COLORS.line(6)) },
    "a ring" to { ring(100.0, 50.0, 20.0, COLORS.line(7), 3.0) },
    "a rectangle" to { rectangle(20.0, 30.0, 60.5, 25.0, faded(COLORS.line(8), 0.5)) },
    "what is moved and clipped" to {
        moved(30.0, 10.0) { clip(0.0, 0.0, 50.0, 40.0) { dots(Points().add(40.0, 30.0), 20.0, COLORS.line(9)) } }
    },
    "what is clipped twice" to {
        clip(20.0, 20.0, 100.0, 60.0) {
            moved(40.0, 10.0) { clip(0.0, 0.0, 150.0, 40.0) { rectangle(-50.0, -50.0, 300.0, 200.0, COLORS.line(3)) } }
            rectangle(0.0, 70.0, 200.0, 20.0, COLORS.line(4))
        }
    },
    "images" to { picture ->
        image(picture, 10.0, 10.0, 80.0, 40.0, opacity = 1.0)
        image(picture, 110.0, 15.0, 60.0, 75.0, opacity = 0.5)
    },
    "a clipped image" to { picture -> clip(60.0, 30.0, 60.0, 50.0) { image(picture, 20.0, 10.0, 160.0, 80.0, opacity = 1.0) } },
    "a layer in two heights" to {
        for ((left, height) in listOf(10.0 to 80.0, 110.0 to 50.0)) {
            layer("primitive", left, 10.0, 80.0, height, emptyList()) { pen, bottom ->
                pen.rectangle(10.0, bottom - 30.0, 50.0, 20.0, COLORS.line(5))
                pen.dots(Points().add(40.0, bottom - 15.0), 12.0, COLORS.line(6))
            }
        }
    },
)

/** The width of a picture with a primitive. */
const val PRIMITIVE_WIDTH: Int = 200

/** The height of a picture with a primitive. */
const val PRIMITIVE_HEIGHT: Int = 100

/** An image of 20 by 10 pixels. It is blue to the left, with a green quarter above, and orange to the right. */
const val PRIMITIVE_IMAGE: String = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAABQAAAAKCAIAAAA7N+mxAAAAH0lEQVR42mOQ7bLBg64ESOFBDCNR" +
    "M3fSETxoVDM6AgC2V+QhrHKk7AAAAABJRU5ErkJggg=="

private val COLORS = PenColors.LIGHT

/** Returns a line over all of a picture, with a gap in its middle. */
private fun wave(): Strokes = strokesOf { if (it in 90..99) Double.NaN else sin(it / 9.0) }

/** Returns two lines with a sample alone before, between and after them. */
private fun besideSamples(): Strokes = strokesOf {
    if (it in 20..70 || it in 110..150 || it == 5 || it == 90 || it == 190) sin(it / 9.0) else Double.NaN
}

/** Returns the line through the values of [yAt] for each column of a picture. */
private fun strokesOf(yAt: (Int) -> Double): Strokes {
    val y = DoubleArray(PRIMITIVE_WIDTH, yAt)
    val curve = Curve(Series(DoubleArray(PRIMITIVE_WIDTH) { it.toDouble() }, y), holdsUntil = null)
    curve.draw(0.0, PRIMITIVE_WIDTH.toDouble(), PixelColumns(PRIMITIVE_WIDTH))
    return Strokes().apply { trace(curve, Scale(0.0, 200.0, 200.0), Scale(1.0, -1.0, 80.0, start = 10.0)) }
}

private fun Points.outline() = add(150.0, 20.0).add(180.0, 20.0).add(165.0, 50.0)
