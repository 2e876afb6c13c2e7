package badlog.viewer.graph.plot

import badlog.analysis.Span
import badlog.analysis.Units
import badlog.plot.lane.laneBlocks
import kotlin.math.ceil

/** How many lines and lanes one graph draws; nobody can tell more apart. */
internal const val MOST_LINES = 64

/** How high a lane is, in dp, where there is room. */
internal const val LANE_HEIGHT = 22

/** Finds out all that is to be drawn for [request]. Takes a while: not for the window's thread. */
internal fun makePicture(request: PlotRequest, curves: CurveCache): PlotPicture {
    val (states, numbers) = drawnLines(request.spec, request.recordings)
        .filter { line -> visibleOf(line, request).width.let { it > 0 && it.isFinite() } }
        .take(MOST_LINES)
        .partition { it.signal.states != null }
    val lanesHeight = lanesHeight(request, states.size, hasLines = numbers.isNotEmpty())
    val plotHeight = request.height - lanesHeight
    val points = numbers.map { pointsOf(it, request, curves) }
    val units = numbers.map { unitOf(it) }.distinct()
    val axes = axesOf(request, units, plotHeight) { unit -> points.filterIndexed { i, _ -> unitOf(numbers[i]) == unit } }
    val lines = numbers.mapIndexed { i, line -> linePicture(line, units.indexOf(unitOf(line)), axes, points[i], plotHeight) }
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

private fun pointsOf(line: DrawnLine, request: PlotRequest, curves: CurveCache): CurvePoints {
    val visible = visibleOf(line, request)
    return curves.curve(line.recording, line.signal).draw(visible.from, visible.to, request.width) {
        CurvePoints.of(it, visible, request.width)
    }
}

private fun linePicture(line: DrawnLine, axis: Int, axes: List<YAxis>, points: CurvePoints, height: Float) = LinePicture(
    line = line,
    series = line.signal.series,
    axis = axis,
    points = points.polylines { axes[axis].pixelOf(it, height) },
    dots = points.dots { axes[axis].pixelOf(it, height) },
    isDense = points.isDense,
    hasDots = points.isSparse,
)

private fun lanePicture(line: DrawnLine, request: PlotRequest, curves: CurveCache): LanePicture {
    val runs = curves.runs(line.recording, line.signal)
    val shortest = ceil(SHORTEST * request.density).toInt()
    return LanePicture(
        line = line,
        series = line.signal.series,
        states = line.signal.states.orEmpty(),
        blocks = laneBlocks(runs, visibleOf(line, request), request.width.toDouble(), shortest),
    )
}

/** The width of the shortest state, in dp. */
private const val SHORTEST = 1.5
