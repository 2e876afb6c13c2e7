package badlog.window.graph.xy

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.PointMode
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Span
import badlog.signals.pose.PoseRole
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.path.Plane
import badlog.viewer.draw.path.XyMark
import badlog.viewer.draw.path.XyPlot
import badlog.viewer.draw.path.XyTrace
import badlog.viewer.draw.path.marksAt
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import badlog.window.theme.Palette

/** The numbers of both axes, around the frame [box]. */
internal fun DrawScope.drawXyAxes(plane: Plane, box: Rect, plot: XyPlot, letters: TextMeasurer, palette: Palette) {
    val style = TextStyle(color = palette.muted, fontSize = 11.sp)
    val gap = GAP * density
    val across = Ticks.ofX(plane.x, (box.width / density).toDouble())
    val title = letters.measure(plot.xTitle, style)
    val titleAt = box.right - title.size.width
    across.texts.forEachIndexed { i, number ->
        val text = letters.measure(number, style)
        val at = box.left + plane.xScale(box.width.toDouble()).placeOf(across.values[i]).toFloat() - text.size.width / 2
        if (at + text.size.width + gap < titleAt) drawText(text, topLeft = Offset(maxOf(at, 0f), box.bottom + gap / 2))
    }
    drawText(title, topLeft = Offset(titleAt, box.bottom + gap / 2))
    val up = Ticks.ofY(plane.y, (box.height / density).toDouble())
    val yTitle = letters.measure(plot.yTitle, style)
    up.texts.forEachIndexed { i, number ->
        val text = letters.measure(number, style)
        val at = plane.yScale(box.height.toDouble()).placeOf(up.values[i]).toFloat() - text.size.height / 2
        if (at > yTitle.size.height) {
            drawText(text, topLeft = Offset(box.left - gap - text.size.width, minOf(at, box.height - text.size.height)))
        }
    }
    drawText(yTitle, topLeft = Offset(maxOf(0f, box.left - gap - yTitle.size.width), 0f))
}

/** What is behind the traces: a grid, or the field with its [picture]. */
internal fun DrawScope.drawXyGround(plane: Plane, plot: XyPlot, picture: ImageBitmap?, palette: Palette) {
    val x = plane.xScale(size.width.toDouble())
    val y = plane.yScale(size.height.toDouble())
    val field = plot.field
    val shown = picture?.takeIf { plot.isField }?.let { field.image?.plane(field, it.width, it.height) }
    if (picture != null && shown != null) {
        val (left, top, width, height) = plane.boxOf(shown, size.width.toDouble(), size.height.toDouble()).map { it.toFloat() }
        withTransform({
            translate(left, top)
            scale(width / picture.width, height / picture.height, Offset.Zero)
        }) { drawImage(picture, alpha = PICTURE) }
    }
    val grid = palette.text.copy(alpha = GRID)
    for (value in Ticks.ofX(plane.x, size.width.toDp().value.toDouble()).values) {
        drawLine(grid, Offset(x.placeOf(value).toFloat(), 0f), Offset(x.placeOf(value).toFloat(), size.height))
    }
    for (value in Ticks.ofY(plane.y, size.height.toDp().value.toDouble()).values) {
        drawLine(grid, Offset(0f, y.placeOf(value).toFloat()), Offset(size.width, y.placeOf(value).toFloat()))
    }
    if (!plot.isField) return
    fun at(fieldX: Double, fieldY: Double) = Offset(x.placeOf(fieldX).toFloat(), y.placeOf(fieldY).toFloat())
    val corner = at(0.0, field.width)
    val other = at(field.length, 0.0)
    drawRect(palette.muted, corner, Size(other.x - corner.x, other.y - corner.y), style = Stroke(1.5f * density))
    drawLine(palette.muted.copy(alpha = QUIET), at(field.length / 2, 0.0), at(field.length / 2, field.width), 1f * density)
    drawLine(BLUE_WALL, at(0.0, 0.0), at(0.0, field.width), WALL * density)
    drawLine(RED_WALL, at(field.length, 0.0), at(field.length, field.width), WALL * density)
}

/** Draws all traces of [xy]: faintly outside [visible], and on top of that the visible part. */
internal fun DrawScope.drawXyTraces(xy: DrawnXy, spec: BoardGraph, plane: Plane, visible: Span, palette: Palette) {
    val own = xy.own(visible)
    val all = Span(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
    val isAll = xy.drawn.recording.span.let { it.from in own && it.to in own }
    for (trace in xy.shown(spec)) {
        val color = palette.line(xy.colorOf(trace))
        if (!isAll && xy.plot.isField) drawXyTrace(xy, trace, all, plane, color.copy(alpha = FAINT))
        drawXyTrace(xy, trace, own, plane, color)
    }
}

private fun DrawScope.drawXyTrace(xy: DrawnXy, trace: XyTrace, span: Span, plane: Plane, color: Color) {
    if (trace.followers.isNotEmpty()) return
    trace.draw(span, plane, size.width.toInt(), size.height.toInt(), xy.strokes)
    if (trace.isJoined) drawXyLines(xy.strokes, color, isDashed = trace.role == PoseRole.PLANNED) else drawXyRows(xy.strokes, color)
    val dots = List(xy.strokes.dotsSize / 2) { Offset(xy.strokes.dots[2 * it].toFloat(), xy.strokes.dots[2 * it + 1].toFloat()) }
    drawPoints(dots, PointMode.Points, color, DOT * density, StrokeCap.Round)
}

/** Draws the rows of pixels that many dots are in, as thick as dots. */
private fun DrawScope.drawXyRows(rows: Strokes, color: Color) {
    val size = DOT * density
    for (i in 0 until rows.count) {
        val at = rows.startOf(i)
        val left = rows.points[at].toFloat()
        val long = rows.points[at + 2].toFloat() - left - 1 + size
        drawRect(color, Offset(left + (1 - size) / 2, rows.points[at + 1].toFloat() - size / 2), Size(long, size))
    }
}

private fun DrawScope.drawXyLines(strokes: Strokes, color: Color, isDashed: Boolean) {
    val path = Path()
    for (i in 0 until strokes.count) {
        for (at in strokes.startOf(i) until strokes.endOf(i) step 2) {
            val x = strokes.points[at].toFloat()
            val y = strokes.points[at + 1].toFloat()
            if (at == strokes.startOf(i)) path.moveTo(x, y) else path.lineTo(x, y)
        }
    }
    val dashes = if (isDashed &&
        !strokes.isDense
    ) {
        PathEffect.dashPathEffect(floatArrayOf(DASH * density, DASH * density * GAP_SHARE))
    } else {
        null
    }
    // A hairline is many times faster than any other stroke.
    drawPath(path, color, style = Stroke(if (strokes.isDense) Stroke.HairlineWidth else LINE * density, pathEffect = dashes))
}

/** Draws the result of [xy]: where the robot left its plan, or the line fitted to the samples with its values. */
internal fun DrawScope.drawXyNotes(xy: DrawnXy, plane: Plane, visible: Span, letters: TextMeasurer, palette: Palette) {
    val x = plane.xScale(size.width.toDouble())
    val y = plane.yScale(size.height.toDouble())
    fun note(text: String, at: Offset, color: Color) {
        val measured = letters.measure(text, TextStyle(color = color, fontSize = 12.sp))
        val left = at.x.coerceIn(0f, maxOf(0f, size.width - measured.size.width))
        val top = at.y.coerceIn(0f, maxOf(0f, size.height - measured.size.height))
        drawRect(palette.surface.copy(alpha = VEIL), Offset(left, top), Size(measured.size.width.toFloat(), measured.size.height.toFloat()))
        drawText(measured, topLeft = Offset(left, top))
    }
    xy.departure?.let { departure ->
        val trail = xy.plot.driven?.trail ?: return@let
        val place = Offset(x.placeOf(trail.x[departure.index]).toFloat(), y.placeOf(trail.y[departure.index]).toFloat())
        drawCircle(palette.warning, RING * density, place, style = Stroke(2f * density))
        val axis = xy.drawn.recording.view.xAxis
        val moment = withUnit(placeText(departure.time, axis, xy.drawn.recording.span.width), axis.unit)
        note(departure.text(moment), place + Offset(RING * density, RING * density), palette.warning)
    }
    xy.plot.lineFit(xy.own(visible))?.let { fit ->
        fun at(value: Double) = Offset(x.placeOf(value).toFloat(), y.placeOf(fit.offset + fit.slope * value).toFloat())
        drawLine(palette.muted, at(plane.x.from), at(plane.x.to), LINE * density)
        note(xy.plot.textOf(fit), Offset(size.width, 0f), palette.text)
    }
}

/**
 * Draws everything at its place at [cursor]: robots with their bows, planned ones only as outlines, others as dots; for the second cursor,
 * as rings.
 */
internal fun DrawScope.drawXyCursor(
    xy: DrawnXy,
    spec: BoardGraph,
    plane: Plane,
    cursor: Double,
    palette: Palette,
    isSecond: Boolean = false,
) {
    for (mark in xy.plot.marksAt(cursor - xy.drawn.offset, spec.hidden)) {
        val color = xy.colorOf(mark, palette)
        if (mark.isDot) {
            val x = plane.xScale(size.width.toDouble()).placeOf(mark.places[0]).toFloat()
            val y = plane.yScale(size.height.toDouble()).placeOf(mark.places[1]).toFloat()
            if (isSecond) {
                drawCircle(color, (DOT + 1) * density, Offset(x, y), style = Stroke(LINE * density))
            } else {
                drawCircle(palette.surface, DOT * density, Offset(x, y))
                drawCircle(color, (DOT - 1) * density, Offset(x, y))
            }
            continue
        }
        val path = pathOf(mark.places, plane)
        if (mark.isClosed) path.close()
        if (mark.isFilled && !isSecond) drawPath(path, color.copy(alpha = FILL))
        drawPath(path, color, style = Stroke((if (mark.isTarget) TARGET_ARROW else LINE) * density))
    }
}

/** Returns the color of [mark]. */
internal fun DrawnXy.colorOf(mark: XyMark, palette: Palette): Color =
    mark.color?.let { palette.line(colorOf(it)) } ?: if (mark.isTarget) palette.muted else palette.accent

private fun DrawScope.pathOf(places: DoubleArray, plane: Plane): Path {
    val x = plane.xScale(size.width.toDouble())
    val y = plane.yScale(size.height.toDouble())
    val path = Path()
    for (i in places.indices step 2) {
        val atX = x.placeOf(places[i]).toFloat()
        val atY = y.placeOf(places[i + 1]).toFloat()
        if (i == 0) path.moveTo(atX, atY) else path.lineTo(atX, atY)
    }
    return path
}

/** The wall of the blue alliance. */
internal val BLUE_WALL = Color(0xFF2F6FDE)

/** The wall of the red alliance. */
internal val RED_WALL = Color(0xFFD93A3A)
private const val GAP = 6
private const val GRID = 0.08f
private const val PICTURE = 0.6f
private const val QUIET = 0.5f
private const val WALL = 3
private const val FAINT = 0.25f
private const val FILL = 0.25f
private const val VEIL = 0.85f
private const val LINE = 1.75f
private const val TARGET_ARROW = 3.5f
private const val DASH = 6f
private const val GAP_SHARE = 0.7f
private const val DOT = 4f
private const val RING = 9
