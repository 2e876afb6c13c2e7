package badlog.viewer.export.figure

import badlog.analysis.Span
import badlog.plot.board.BoardGraph
import badlog.plot.curve.Scale
import badlog.plot.curve.Strokes
import badlog.rules.path.PoseRole
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.graph.xy.drawnXys
import badlog.viewer.graph.xy.seenOf
import badlog.viewer.theme.Palette

/** The frame of [graph], whose lines are drawn over each other: what the [recordings] have in [visible]; null for nothing. */
internal fun xyFrame(graph: BoardGraph, recordings: List<DrawnRecording>, visible: Span, width: Int): FigureFrame? {
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
            val label = if (recordings.size > 1) "${trace.name}, ${xy.drawn.name}" else trace.name
            val color = hexOf(Palette.LIGHT.line(xy.colorOf(trace)))
            FigureLine(plainLine(label, LABEL_LETTERS), color, strokes, isDashed = trace.role == PoseRole.PLANNED)
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
        plane = FigurePlane(plane.x, plainLine(plot.xTitle, LABEL_LETTERS), plot.field.takeIf { plot.isField }),
    )
}

private const val LABEL_LETTERS = 30
