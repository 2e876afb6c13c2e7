package badlog.window.graph.xy

import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.path.Departure
import badlog.viewer.draw.path.XyDrawing
import badlog.viewer.draw.pen.Pen
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit

/**
 * Draws [xys] with [pen] in a frame of [width] by [height] pixels that shows [plane]: the part in [visible], and on a field faintly the rest.
 *
 * @param axesFrom the room for the axes to the left of the frame; null if they are not drawn with it.
 */
internal fun drawXys(
    pen: Pen,
    xys: List<DrawnXy>,
    spec: BoardGraph,
    plane: Plane,
    visible: Span,
    width: Float,
    height: Float,
    colors: PenColors,
    axesFrom: Double? = null,
) {
    fun drawing(xy: DrawnXy) = XyDrawing(pen, xy.plot, plane, width.toDouble(), height.toDouble(), colors)
    xys.firstOrNull()?.let { drawing(it).ground(it.drawn.recording.fieldPicture) }
    if (axesFrom != null) xys.firstOrNull()?.let { drawing(it).axes(axesFrom) }
    for (xy in xys) {
        val own = xy.own(visible)
        val isAll = xy.drawn.recording.span.let { it.from in own && it.to in own }
        drawing(xy).traces(xy.shown(spec), own, isAll, xy.strokes, xy::colorOf)
    }
    for (xy in xys) drawing(xy).notes(xy.own(visible), xy.departure) { textOf(xy, it) }
}

/** Draws everything at its place at [cursors]; for the second one, as rings. */
internal fun drawXyCursors(
    pen: Pen,
    xys: List<DrawnXy>,
    spec: BoardGraph,
    plane: Plane,
    cursors: Cursors,
    width: Float,
    height: Float,
    colors: PenColors,
) {
    for ((cursor, isSecond) in listOf(cursors.second to true, cursors.x to false)) {
        if (cursor == null) continue
        for (xy in xys) {
            XyDrawing(pen, xy.plot, plane, width.toDouble(), height.toDouble(), colors)
                .marks(cursor - xy.drawn.offset, spec.hidden, isSecond) { xy.colorOf(it) }
        }
    }
}

private fun textOf(xy: DrawnXy, departure: Departure): String {
    val axis = xy.drawn.recording.view.xAxis
    return departure.text(withUnit(placeText(departure.time, axis, xy.drawn.recording.span.width), axis.unit))
}
