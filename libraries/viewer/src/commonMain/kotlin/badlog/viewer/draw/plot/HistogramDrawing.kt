package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.TextSide
import badlog.viewer.shown.statistics.Histogram
import badlog.viewer.text.fixedText
import badlog.viewer.text.withUnit
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/**
 * Draws [histogram] of a line in [unit], in the color of line [color]. It has a bar for each bin, the values below, and the share of the
 * highest bar above; it is [width] physical pixels wide and [HISTOGRAM_HEIGHT] high.
 */
fun Pen.drawHistogram(histogram: Histogram, unit: String, color: Int, width: Double, colors: PenColors) {
    val letters = AXIS_LETTERS * density
    val left = SIDE * density
    val wide = width - 2 * left
    val top = 1.5 * letters
    val bottom = HISTOGRAM_HEIGHT * density - 2 * letters
    if (wide < 1) return
    val most = histogram.shares.max()
    val bar = wide / histogram.shares.size
    histogram.shares.forEachIndexed { i, share ->
        // A value that hardly lasts is still visible.
        val high = if (share > 0) maxOf(1.0, share / most * (bottom - top)) else 0.0
        rectangle(left + i * bar, bottom - high, maxOf(1.0, bar - density), high, colors.line(color))
    }
    segments(Points().line(left, bottom, left + wide, bottom), colors[Shade.MUTED], density)
    text("highest bar: ${fixedText(most * PERCENT, 1)} % of the time", left, letters / 2, letters, colors[Shade.MUTED])
    val values = histogram.values
    val x = Scale.ofX(values, wide, left)
    val ticks = Ticks.ofX(Span(values.from, values.to), wide / density)
    val texts = ticks.texts
    ticks.values.forEachIndexed { i, value ->
        val text = if (i == texts.lastIndex) withUnit(texts[i], unit) else texts[i]
        val half = widthOf(text, letters) / 2
        val middle = x.placeOf(value).coerceIn(half, maxOf(half, width - half))
        text(text, middle, bottom + letters, letters, colors[Shade.MUTED], TextSide.CENTER)
    }
}

/** The height of a histogram, in CSS pixels or dp. */
const val HISTOGRAM_HEIGHT: Int = 120

private const val SIDE = 12.0
private const val PERCENT = 100

/** Returns the [ROUNDED_CORNERS] corners of a box that is rounded with [radius], clockwise. */
internal fun roundedBox(left: Double, top: Double, width: Double, height: Double, radius: Double): Points {
    val points = Points()
    for (quarter in 0 until QUARTERS) {
        val centerX = if (quarter == 0 || quarter == QUARTERS - 1) left + width - radius else left + radius
        val centerY = if (quarter < 2) top + height - radius else top + radius
        for (step in 0..STEPS) {
            val angle = (quarter + step.toDouble() / STEPS) * PI / 2
            points.add(centerX + radius * cos(angle), centerY + radius * sin(angle))
        }
    }
    return points
}

private const val QUARTERS = 4

/** The number of steps in a quarter of a circle: more are invisible at a radius of a few pixels. */
private const val STEPS = 4

internal const val ROUNDED_CORNERS: Int = QUARTERS * (STEPS + 1)
