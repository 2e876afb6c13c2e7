package badlog.viewer.draw.plot

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points
import badlog.viewer.shown.cursor.Cursors

/** Draws [cursors] over the height of [frame]: the pinned one, the second one dashed, and the pointer's place thin. */
fun Pen.drawCursors(frame: PlotFrame, cursors: Cursors, colors: PenColors) {
    val accent = colors[Shade.ACCENT]
    val pointer = faded(colors[Shade.CURSOR], if (cursors.isPinned) POINTER_OPACITY else CURSOR_OPACITY)
    drawLine(frame, cursors.hover, pointer, density)
    drawLine(frame, cursors.pinned, accent, PINNED * density)
    drawLine(frame, cursors.second, accent, PINNED * density, DASH * density)
}

private fun Pen.drawLine(frame: PlotFrame, x: Double?, color: Int, width: Double, dash: Double = 0.0) {
    if (x == null || x !in frame.shown) return
    val place = frame.x.placeOf(x)
    segments(Points().line(place, frame.top, place, frame.bottom), color, width, dash)
}

/** Draws a dot at ([x], [y]), in pixels, in the color of line [color]. */
internal fun Pen.drawSample(x: Double, y: Double, color: Int, colors: PenColors) {
    val place = Points().add(x, y)
    dots(place, (DOT + 1) * density, colors[Shade.SURFACE])
    dots(place, DOT * density, colors.line(color))
}

private const val CURSOR_OPACITY = 0.75
private const val POINTER_OPACITY = 0.4
private const val PINNED = 2.0
private const val DASH = 4.0
private const val DOT = 3.0
