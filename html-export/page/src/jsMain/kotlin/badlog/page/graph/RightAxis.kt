package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.view.Palette
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.color.Shade
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D

/**
 * Draws the numbers of [axis] along the right edge of [frame], within it: beside it they would take width from all graphs, whose x axes
 * must be aligned, although only a few graphs need it.
 */
internal fun drawRightAxis(context: CanvasRenderingContext2D, frame: PlotFrame, axis: GraphAxis, shown: Span, palette: Palette) {
    val ratio = window.devicePixelRatio
    val ticks = Ticks.ofY(shown, frame.height / ratio)
    val y = frame.scaleOf(shown)
    context.save()
    context.font = axisFont(ratio)
    context.asDynamic().textBaseline = "middle"
    context.asDynamic().textAlign = "right"
    context.asDynamic().lineJoin = "round"
    context.lineWidth = HALO * ratio
    context.strokeStyle = palette[Shade.SURFACE]
    context.fillStyle = axisColor(axis, palette)
    ticks.texts.forEachIndexed { i, number ->
        // The unit is shown once, at the top.
        val text = if (i == ticks.texts.lastIndex && axis.unit.isNotEmpty()) "$number ${axis.unit}" else number
        val half = AXIS_LETTERS / 2 * ratio
        val middle = y.placeOf(ticks.values[i]).coerceIn(frame.top + half, frame.bottom - half)
        context.strokeText(text, frame.right - MARGIN * ratio, middle)
        context.fillText(text, frame.right - MARGIN * ratio, middle)
    }
    context.restore()
}

/** Returns the color of the numbers of [axis], one of several: that of its line, if it has only one. */
internal fun axisColor(axis: GraphAxis, palette: Palette): String = axis.lines.singleOrNull()?.let(palette::line) ?: palette[Shade.MUTED]

private const val HALO = 3.0
private const val MARGIN = 3.0
