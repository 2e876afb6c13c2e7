package badlog.viewer.graph.plot

import badlog.analysis.Span
import badlog.analysis.Units
import badlog.plot.curve.Scale
import badlog.plot.lane.LaneBlocks
import badlog.plot.lane.LaneLook
import kotlin.math.ceil

/** How many lines and lanes one graph draws; nobody can tell more apart. */
internal const val MAX_LINES = 64

/** How high a lane is, in dp, where there is room. */
internal const val LANE_HEIGHT = 22

/** Finds out all that is to be drawn for [request]. Takes a while: not for the window's thread. */
internal fun makePicture(request: PlotRequest, curves: CurveCache): PlotPicture {
    val (states, numbers) = drawnLines(request.spec, request.recordings)
        .filter { line -> visibleOf(line, request).width.let { it > 0 && it.isFinite() } }
        .take(MAX_LINES)
        .partition { it.signal.states != null }
    val lanesHeight = lanesHeight(request, states.size, hasLines = numbers.isNotEmpty())
    val plotHeight = request.height - lanesHeight
    val strokes = numbers.map { curves.curve(it.recording, it.signal).trace(visibleOf(it, request), request.width) }
    val units = numbers.map { unitOf(it) }.distinct()
    val axes = axesOf(request, units, plotHeight) { unit -> strokes.filterIndexed { i, _ -> unitOf(numbers[i]) == unit } }
    val lines = numbers.mapIndexed { i, line ->
        val axis = units.indexOf(unitOf(line))
        strokes[i].place(Scale.ofY(axes[axis].shown, plotHeight.toDouble()))
        LinePicture(line, axis, strokes[i])
    }
    return PlotPicture(
        request = request,
        axes = axes,
        lines = lines,
        lanes = states.map { lanePicture(it, request, curves) },
        image = rasterOf(request, axes, lines, plotHeight),
        plotHeight = plotHeight,
    )
}

private fun unitOf(line: DrawnLine) = if (Units.isNone(line.signal.unit)) "" else line.signal.unit

private fun lanesHeight(request: PlotRequest, lanes: Int, hasLines: Boolean): Float {
    val room = request.height.toFloat()
    return when {
        lanes == 0 -> 0f
        hasLines -> minOf(lanes * LANE_HEIGHT * request.density, room / 2)
        else -> room
    }
}

/** What of the line's own x is visible. */
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
