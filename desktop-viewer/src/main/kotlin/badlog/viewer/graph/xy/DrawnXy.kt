package badlog.viewer.graph.xy

import badlog.analysis.Span
import badlog.plot.board.BoardGraph
import badlog.plot.curve.Strokes
import badlog.plot.path.Departure
import badlog.plot.path.Plane
import badlog.plot.path.XyPlot
import badlog.plot.path.XyTrace
import badlog.plot.path.shown
import badlog.viewer.compare.DrawnRecording

/**
 * What one of the recordings that are drawn shows of y over x.
 *
 * @property index its place among those recordings, of which there are [count].
 */
internal class DrawnXy(val drawn: DrawnRecording, val plot: XyPlot, private val index: Int, private val count: Int) {
    /** The strokes of the trace that is being drawn. They are reused, since allocating arrays for a million poses in each frame takes long. */
    val strokes = Strokes()

    /** Where the robot left its plan. */
    val departure: Departure? by lazy { plot.departure(drawn.recording.view) }

    /** Which of the palette's colors [trace] has: as in other graphs, of several recordings the first ones tell them apart. */
    fun colorOf(trace: XyTrace): Int = colorOf(trace.color)

    /** The same of a mark that has the [color] of a trace. */
    fun colorOf(color: Int): Int = color * count + index

    /** What of its own x is seen where the window shows [visible]. */
    fun own(visible: Span): Span = Span(visible.from - drawn.offset, visible.to - drawn.offset)

    /** What of it is not hidden in [spec]. */
    fun shown(spec: BoardGraph): List<XyTrace> = plot.shown(spec.hidden)
}

/** What each of [recordings] shows in [graph], where it has any of its lines. */
internal fun drawnXys(graph: BoardGraph, recordings: List<DrawnRecording>): List<DrawnXy> = recordings.mapIndexedNotNull { i, drawn ->
    drawn.recording.xyPlot(graph.lines, graph.origin)?.let { DrawnXy(drawn, it, i, recordings.size) }
}

/** All there is to see of [xys], on [width] by [height] pixels; null for nothing. */
internal fun wholeOf(xys: List<DrawnXy>, width: Float, height: Float): Plane? {
    val first = xys.firstOrNull() ?: return null
    val whole = Plane(spanOf(xys.map { it.plot.full.x }), spanOf(xys.map { it.plot.full.y }))
    return if (first.plot.isField) whole.fitted(width.toDouble(), height.toDouble()) else whole
}

/** [selected], as wide and high as a frame of [width] by [height] pixels, or all there is to see of [xys]; null for nothing. */
internal fun seenOf(selected: Plane?, xys: List<DrawnXy>, width: Float, height: Float): Plane? {
    if (selected?.isDrawable != true) return wholeOf(xys, width, height)
    return if (isField(xys)) selected.fitted(width.toDouble(), height.toDouble()) else selected.takeIf { xys.isNotEmpty() }
}

internal fun isField(xys: List<DrawnXy>): Boolean = xys.firstOrNull()?.plot?.isField == true

private fun spanOf(spans: List<Span>) = Span(spans.minOf { it.from }, spans.maxOf { it.to })
