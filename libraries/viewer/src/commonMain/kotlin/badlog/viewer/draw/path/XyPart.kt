package badlog.viewer.draw.path

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.signals.clock.secondsPerX
import badlog.signals.pose.Pose
import badlog.signals.pose.posesOf
import badlog.signals.swerve.swerveModulesOf
import badlog.viewer.choices.board.FieldOrigin
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

/** The legend's entry for [trace], which [part] draws. */
class XyEntry internal constructor(private val part: XyPart, private val trace: XyTrace) {
    /** The name of the trace. */
    val name: String get() = trace.name

    /** The name of the trace's log; null if no other log is drawn. */
    val log: String? get() = part.log.name.takeIf { part.isCompared }

    /** The names of the trace's lines, by which a board hides it. */
    val lines: List<String> get() = trace.lines

    /** The index of the trace's color in the palette. */
    val color: Int get() = part.colorOf(trace.color)

    /** The name of the trace, with the log's name unless that is the open log. */
    val title: String get() = if (part.index == 0) name else "$name (${part.log.name})"

    /** Returns whether the trace is drawn while the lines in [hidden] are not. */
    fun isShown(hidden: Set<String>): Boolean = lines.none { it in hidden }

    /** Returns the trace's places at [cursors], or its numbers if it is not on a field. Empty if it has none there. */
    fun textAt(cursors: Cursors): String {
        val texts = listOfNotNull(cursors.x, cursors.second).map { trace.textAt(it - part.log.offset, part.plot.isField) }
        return if (texts.all { it.isEmpty() }) "" else texts.joinToString(" → ") { it.ifEmpty { NOWHERE } }
    }
}

/**
 * A log that graphs of y over x draw.
 *
 * @property paths the log's content for such graphs.
 * @property name the log's name beside the others.
 * @property offset the number that is added to the log's x.
 */
class XyLog(val paths: LogPaths, val name: String = "", val offset: Double = 0.0)

/**
 * The content of a log that graphs of y over x can draw.
 *
 * @param field the field of its paths.
 * @param line finds a line of the log by its name.
 */
class LogPaths(internal val view: LogView, private val field: Field, private val line: (String) -> GraphSeries?) {
    /** The poses in the log's topics. */
    val poses: List<Pose> = posesOf(view.recording.topics)

    private val modules = swerveModulesOf(view.recording.topics)

    /** Returns the plot of y over x for a graph of [lines], with poses measured from [origin]. Null if there is nothing to draw. */
    fun plotOf(lines: List<String>, origin: FieldOrigin = FieldOrigin.BLUE): XyPlot? =
        xyPlotOf(lines, poses, modules, origin.flipIn(view, field), field, view.secondsPerX, line)
}

private const val NOWHERE = "–"
