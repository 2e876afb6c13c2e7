package badlog.window.graph.plot

import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneLook
import kotlin.math.ceil

/** The maximum number of lines and lanes in a graph; nobody can distinguish more. */
internal const val MAX_LINES = 64

/**
 * Returns everything to be drawn for [request]; with an image of its lines for the screen if it [hasImage]. It takes a while, so do not use
 * it on the window's thread.
 */
internal fun makePicture(request: PlotRequest, curves: CurveCache, hasImage: Boolean = true): PlotPicture {
    val (states, numbers) = shownLines(request.spec, request).partition { it.signal.states != null }
    val lanesHeight = lanesHeight(request, states.size, hasLines = numbers.isNotEmpty())
    val plotHeight = request.height - lanesHeight
    val strokes = strokesOf(numbers, request, curves)
    val ofUnits = graphAxes(numbers.map { it.signal.unit })
    val seen = ofUnits.map { axis -> seenOf(axis.unit, axis.lines.map(strokes::get)) }
    val together = if (request.spec.sharesY) seenTogether(seen + request.sharing.flatMap { seenIn(it, request, curves) }) else emptyMap()
    val axes = yAxesOf(request, ofUnits, seen.map { together[it.unit] ?: it }, plotHeight)
    val lines = numbers.mapIndexed { i, line ->
        val axis = ofUnits.indexOfFirst { i in it.lines }
        strokes[i].place(Scale.ofY(axes[axis].shown, plotHeight.toDouble()))
        LinePicture(line, axis, strokes[i])
    }
    val lanes = states.map { lanePicture(it, request, curves) }
    val picture = PlotPicture(request, axes, lines, lanes, image = null, plotHeight)
    return if (hasImage) PlotPicture(request, axes, lines, lanes, rasterOf(picture), plotHeight) else picture
}

private fun shownLines(spec: BoardGraph, request: PlotRequest) = drawnLines(spec, request.recordings)
    .filter { line -> line.signal.name !in spec.hidden && visibleOf(line, request).width.let { it > 0 && it.isFinite() } }
    .take(MAX_LINES)

private fun strokesOf(numbers: List<DrawnLine>, request: PlotRequest, curves: CurveCache) =
    numbers.map { curves.curve(it.recording, it.signal).trace(visibleOf(it, request), request.width) }

/** Returns what is visible of each unit in [spec], another graph that shares the y limits. */
private fun seenIn(spec: BoardGraph, request: PlotRequest, curves: CurveCache): List<SeenOfUnit> {
    val numbers = shownLines(spec, request).filter { it.signal.states == null }
    val strokes = strokesOf(numbers, request, curves)
    return graphAxes(numbers.map { it.signal.unit }).map { axis -> seenOf(axis.unit, axis.lines.map(strokes::get)) }
}

private fun lanesHeight(request: PlotRequest, lanes: Int, hasLines: Boolean): Float {
    val room = request.height.toFloat()
    return when {
        lanes == 0 -> 0f
        hasLines -> minOf(lanes * LaneLook.HEIGHT * request.density, room / 2)
        else -> room
    }
}

/** Returns the visible part of the line's own x. */
private fun visibleOf(line: DrawnLine, request: PlotRequest) = Span(request.visible.from - line.offset, request.visible.to - line.offset)

private fun lanePicture(line: DrawnLine, request: PlotRequest, curves: CurveCache): LanePicture {
    val runs = curves.runs(line.recording, line.signal)
    val shortest = ceil(LaneLook.MIN_BLOCK * request.density).toInt()
    return LanePicture(
        line = line,
        states = line.signal.states.orEmpty(),
        blocks = LaneBlocks().apply { place(runs, visibleOf(line, request), request.width.toDouble(), shortest) },
    )
}
