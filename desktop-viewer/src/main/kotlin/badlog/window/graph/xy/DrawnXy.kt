package badlog.window.graph.xy

import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.path.Departure
import badlog.viewer.draw.path.XyPlot
import badlog.viewer.draw.path.XyTrace
import badlog.viewer.draw.path.shown
import badlog.viewer.shown.comparison.colorOf
import badlog.window.compare.DrawnRecording

/**
 * The graph of y over x of one drawn recording.
 *
 * @property index its index among the [count] drawn recordings.
 */
internal class DrawnXy(val drawn: DrawnRecording, val plot: XyPlot, private val index: Int, private val count: Int) {
    /** The strokes of the trace that is being drawn. They are reused, since allocating arrays for a million poses in each frame takes long. */
    val strokes = Strokes()

    /** Where the robot left its plan. */
    val departure: Departure? by lazy { plot.departure(drawn.recording.view) }

    /** Returns the palette index of the color of [trace]: as in other graphs, with several recordings the first colors distinguish them. */
    fun colorOf(trace: XyTrace): Int = colorOf(trace.color)

    /** Returns the same for a mark with the [color] of a trace. */
    fun colorOf(color: Int): Int = colorOf(color, index, count)

    /** Returns the part of its own x that is visible if the window shows [visible]. */
    fun own(visible: Span): Span = Span(visible.from - drawn.offset, visible.to - drawn.offset)

    /** Returns its traces that are not hidden in [spec]. */
    fun shown(spec: BoardGraph): List<XyTrace> = plot.shown(spec.hidden)
}

/** Returns the graphs of those of [recordings] that have any lines of [graph]. */
internal fun drawnXys(graph: BoardGraph, recordings: List<DrawnRecording>): List<DrawnXy> = recordings.mapIndexedNotNull { i, drawn ->
    drawn.recording.xyPlot(graph.lines, graph.origin)?.let { DrawnXy(drawn, it, i, recordings.size) }
}

/** Returns the whole extent of [xys], on [width] by [height] pixels; null for nothing. */
internal fun wholeOf(xys: List<DrawnXy>, width: Float, height: Float): Plane? {
    val first = xys.firstOrNull() ?: return null
    val whole = Plane(spanOf(xys.map { it.plot.full.x }), spanOf(xys.map { it.plot.full.y }))
    return if (first.plot.isField) whole.fitted(width.toDouble(), height.toDouble()) else whole
}

/** Returns [selected], fitted to a frame of [width] by [height] pixels, or the whole extent of [xys]; null for nothing. */
internal fun seenOf(selected: Plane?, xys: List<DrawnXy>, width: Float, height: Float): Plane? {
    if (selected?.isDrawable != true) return wholeOf(xys, width, height)
    return if (isField(xys)) selected.fitted(width.toDouble(), height.toDouble()) else selected.takeIf { xys.isNotEmpty() }
}

internal fun isField(xys: List<DrawnXy>): Boolean = xys.firstOrNull()?.plot?.isField == true

private fun spanOf(spans: List<Span>) = Span(spans.minOf { it.from }, spans.maxOf { it.to })
