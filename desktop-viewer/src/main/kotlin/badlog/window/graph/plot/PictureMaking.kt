package badlog.window.graph.plot

import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.seenOn
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.plot.PlotLane
import badlog.viewer.draw.plot.plotOf

/** The maximum number of lines and lanes in a graph; a person cannot distinguish more. */
internal const val MAX_LINES = 64

/**
 * Returns the picture for [request], with an image of its lines for the screen if [hasImage]. It takes a while: call it off the window's
 * thread.
 */
internal fun makePicture(request: PlotRequest, curves: CurveCache, hasImage: Boolean = true): PlotPicture {
    val (states, numbers) = shownLines(request.spec, request).partition { it.signal.states != null }
    val strokes = strokesOf(numbers, request, curves)
    val shared = if (request.spec.sharesY) seen(numbers, strokes) + request.sharing.flatMap { seenIn(it, request, curves) } else emptyList()
    val lanes = states.map { PlotLane(laneName(it, states), it.signal.states.orEmpty(), blocksOf(it, request, curves)) }
    val plot = plotOf(request.spec, numbers, strokes, lanes, request.frame, request.density.toDouble(), seenTogether(shared))
    return PlotPicture(request, plot, numbers, states, if (hasImage) rasterOf(request, plot) else null)
}

private fun shownLines(spec: BoardGraph, request: PlotRequest) = drawnLines(spec, request.recordings)
    .filter { line -> line.signal.name !in spec.hidden && visibleOf(line, request).width.let { it > 0 && it.isFinite() } }
    .take(MAX_LINES)

private fun strokesOf(numbers: List<DrawnLine>, request: PlotRequest, curves: CurveCache) =
    numbers.map { curves.curve(it.recording, it.signal).trace(visibleOf(it, request), request.width) }

private fun seen(numbers: List<DrawnLine>, strokes: List<Strokes>) = seenOn(graphAxes(numbers.map { it.signal.unit }), strokes)

/** Returns the visible range of each unit in [spec], another graph that shares the y limits. */
private fun seenIn(spec: BoardGraph, request: PlotRequest, curves: CurveCache): List<SeenOfUnit> {
    val numbers = shownLines(spec, request).filter { it.signal.states == null }
    return seen(numbers, strokesOf(numbers, request, curves))
}

/** Returns the visible part of the line's own x. */
private fun visibleOf(line: DrawnLine, request: PlotRequest) = Span(request.visible.from - line.offset, request.visible.to - line.offset)

private fun blocksOf(line: DrawnLine, request: PlotRequest, curves: CurveCache) = LaneBlocks().apply {
    place(curves.runs(line.recording, line.signal), visibleOf(line, request), request.width.toDouble(), request.density.toDouble())
}
