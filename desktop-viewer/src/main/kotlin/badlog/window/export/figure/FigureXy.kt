package badlog.window.export.figure

import badlog.core.analysis.Span
import badlog.signals.pose.PoseRole
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.path.Plane
import badlog.viewer.draw.path.XyTrace
import badlog.viewer.draw.path.marksAt
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import badlog.window.compare.DrawnRecording
import badlog.window.graph.xy.DrawnXy
import badlog.window.graph.xy.colorOf
import badlog.window.graph.xy.drawnXys
import badlog.window.graph.xy.seenOf
import badlog.window.theme.Palette

/**
 * Returns the frame of [graph], whose lines are drawn over each other: what the [recordings] have in [visible], and where everything
 * is at the [cursors]; null for nothing.
 */
internal fun xyFrame(graph: BoardGraph, recordings: List<DrawnRecording>, visible: Span, width: Int, cursors: Cursors): FigureFrame? {
    val xys = drawnXys(graph, recordings)
    val height = width / 2
    val plane = seenOf(graph.plane, xys, width.toFloat(), height.toFloat()) ?: return null
    val toX = Scale(0.0, width.toDouble(), plane.x.width, plane.x.from)
    val toY = Scale(0.0, height.toDouble(), -plane.y.width, plane.y.to)
    val lines = xys.flatMap { xy ->
        xy.shown(graph).filter { it.followers.isEmpty() }.map { trace ->
            val strokes = Strokes()
            trace.draw(xy.own(visible), plane, width, height, strokes)
            strokes.place(toX, toY)
            val color = hexOf(Palette.LIGHT.line(xy.colorOf(trace)))
            FigureLine(labelOf(xy, trace, cursors, recordings.size > 1), color, strokes, isDashed = trace.role == PoseRole.PLANNED)
        }
    }
    val plot = xys[0].plot
    return FigureFrame(
        title = plainLine(graph.title, LABEL_LETTERS),
        yTitle = plainLine(plot.yTitle, LABEL_LETTERS),
        y = plane.y,
        isFilled = false,
        hasLegend = true,
        lines = lines,
        lanes = emptyList(),
        plane = FigurePlane(
            plane.x,
            plainLine(plot.xTitle, LABEL_LETTERS),
            plot.field.takeIf { plot.isField },
            pictureOf(xys[0]),
            xys.flatMap { notesOf(it, plane, visible) + marksOf(it, graph, cursors) },
            xys.mapNotNull { labelOf(it, plane, visible) },
        ),
    )
}

/** Returns the legend's text for [trace], with its place at the cursor. */
private fun labelOf(xy: DrawnXy, trace: XyTrace, cursors: Cursors, isCompared: Boolean): String {
    val name = if (isCompared) "${trace.name}, ${xy.drawn.name}" else trace.name
    val place = cursors.x?.let { trace.textAt(it - xy.drawn.offset, xy.plot.isField) }.orEmpty()
    return if (place.isEmpty()) plainLine(name, LABEL_LETTERS) else "${plainLine(name, LABEL_LETTERS - place.length - 1)} $place"
}

/** Returns the picture of the field of [xy]; null for none. */
private fun pictureOf(xy: DrawnXy): FigurePicture? {
    val field = xy.plot.field.takeIf { xy.plot.isField } ?: return null
    val image = field.image ?: return null
    val drawn = xy.drawn.recording.fieldPicture ?: return null
    return FigurePicture(image.source, image.plane(field, drawn.width, drawn.height))
}

/** Returns where everything is at the second cursor, as rings and outlines, and then at the first. */
private fun marksOf(xy: DrawnXy, graph: BoardGraph, cursors: Cursors): List<FigureShape> =
    listOfNotNull(cursors.second?.let { it to true }, cursors.x?.let { it to false }).flatMap { (x, isSecond) ->
        xy.plot.marksAt(x - xy.drawn.offset, graph.hidden).map { mark ->
            val color = hexOf(xy.colorOf(mark, Palette.LIGHT))
            FigureShape(mark.places, color, mark.isClosed, mark.isFilled && !isSecond, isRing = mark.isDot && isSecond)
        }
    }

/** Returns where the robot left its plan, as a ring; or the line fitted to the samples. */
private fun notesOf(xy: DrawnXy, plane: Plane, visible: Span): List<FigureShape> {
    val left = placeOfDeparture(xy)?.let { FigureShape(it, hexOf(Palette.LIGHT.warning), isRing = true) }
    val fit = xy.plot.lineFit(xy.own(visible))?.let { fit ->
        val ends = listOf(plane.x.from, plane.x.to).flatMap { listOf(it, fit.offset + fit.slope * it) }
        FigureShape(ends.toDoubleArray(), hexOf(Palette.LIGHT.muted))
    }
    return listOfNotNull(fit, left)
}

/** Returns the text for [notesOf]. */
private fun labelOf(xy: DrawnXy, plane: Plane, visible: Span): FigureLabel? {
    val (x, y) = placeOfDeparture(xy)?.toList() ?: return xy.plot.lineFit(xy.own(visible))?.let { fit ->
        FigureLabel(xy.plot.textOf(fit), plane.x.to, plane.y.to, isLeft = true, isAbove = false, hexOf(Palette.LIGHT.text))
    }
    val departure = xy.departure ?: return null
    val axis = xy.drawn.recording.view.xAxis
    val moment = withUnit(placeText(departure.time, axis, xy.drawn.recording.span.width), axis.unit)
    val isLeft = x > plane.xAt(HALF)
    val isAbove = y < plane.yAt(HALF)
    val gap = plane.x.width * GAP
    return FigureLabel(
        departure.text(moment),
        if (isLeft) x - gap else x + gap,
        if (isAbove) y + gap else y - gap,
        isLeft,
        isAbove,
        hexOf(Palette.LIGHT.warning),
    )
}

/** Returns where the robot of [xy] left its plan, x and y; null for nowhere. */
private fun placeOfDeparture(xy: DrawnXy): DoubleArray? {
    val index = xy.departure?.index ?: return null
    return xy.plot.driven?.trail?.let { doubleArrayOf(it.x[index], it.y[index]) }
}

private const val LABEL_LETTERS = 30
private const val HALF = 0.5

/** The distance of the text from the ring, as a fraction of the width. */
private const val GAP = 0.012
