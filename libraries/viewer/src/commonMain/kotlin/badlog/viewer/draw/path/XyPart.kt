package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.shown.comparison.colorOf
import badlog.viewer.shown.cursor.Cursors

/**
 * The part of an [XyPicture] that shows one log.
 *
 * @property log the log.
 * @property plot the log's plot, over its own x.
 * @property index the log's index among the [count] drawn logs.
 */
class XyPart internal constructor(internal val log: XyLog, val plot: XyPlot, val index: Int, private val count: Int) {
    private val view get() = log.paths.view
    private val departure by lazy { plot.departure(view) }
    private val whole = Viewport.of(view.xAxis.range).full

    /** The legend's entries for the traces, the most important one first. */
    val entries: List<XyEntry> = plot.traces.asReversed().map { XyEntry(this, it) }

    /** Whether other logs are also drawn. */
    internal val isCompared: Boolean get() = count > 1

    /** Returns the palette's index for the [color] of a plot: as in other graphs, colors distinguish the logs first. */
    internal fun colorOf(color: Int): Int = colorOf(color, index, count)

    /** Returns the visible range on the log's own x; [visible] is on the x that all logs share. */
    internal fun own(visible: Span): Span = Span(visible.from - log.offset, visible.to - log.offset)

    /** Draws the traces that are not [hidden], in [visible]. On a field, it also draws the rest faintly. */
    internal fun drawTraces(frame: XyFrame, hidden: Set<String>, visible: Span, strokes: Strokes) {
        val own = own(visible)
        val isAll = whole.from in own && whole.to in own
        XyDrawing(frame, plot).traces(plot.shown(hidden), own, isAll, strokes) { colorOf(it.color) }
    }

    /**
     * Draws the resets of the pose, and the fitted line or the place where the robot left its plan.
     *
     * @param momentOf returns the text of a time on the x that all logs share.
     */
    internal fun drawNotes(frame: XyFrame, visible: Span, momentOf: (Double) -> String) = with(XyDrawing(frame, plot)) {
        val own = own(visible)
        plot.lineFit(own)?.let { fit(it, named(plot.textOf(it)), index) }
        resets(own)
        departure?.let { departure(it, named(it.text(momentOf(it.time + log.offset)))) }
    }

    /** Draws everything that is not [hidden] at its place at [cursors]; at the second one, dots are rings. */
    internal fun drawCursors(frame: XyFrame, hidden: Set<String>, cursors: Cursors) {
        val drawing = XyDrawing(frame, plot)
        cursors.second?.let { drawing.marks(it - log.offset, hidden, isSecond = true) { color -> colorOf(color) } }
        cursors.x?.let { drawing.marks(it - log.offset, hidden, isSecond = false) { color -> colorOf(color) } }
    }

    private fun named(text: String) = if (isCompared) "$text (${log.name})" else text
}
