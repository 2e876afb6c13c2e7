package badlog.page.view

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Event
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.core.analysis.enabledSpans
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.signals.signalTopicsOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.mark.Clocks
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.MARK_REACH
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.mark.markNear
import badlog.viewer.draw.path.Field
import badlog.viewer.draw.path.LogPaths
import badlog.viewer.draw.plot.PlotMarks
import badlog.viewer.panel.LogTimes
import badlog.viewer.session.link.FindingName
import badlog.viewer.shown.comparison.ComparedLog
import badlog.viewer.shown.outline.traits
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import badlog.viewer.shown.statistics.Channels
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.placeText
import badlog.viewer.text.unitText
import badlog.viewer.text.withUnit

/** The data that all parts of the page share: the recording, the findings, the visible range, the cursor, and the [board]. */
internal class Scene(
    val view: LogView,
    val fileName: String,
    val palette: Palette,
    val board: PageBoard,
    val notice: Notice,
    signals: SignalVocabulary,
    val store: PageStore,
) {
    /** The channels of the power distribution, found by the names of signals. */
    val channels: Channels by lazy { Channels.of(view, signalTopicsOf(view, signals)) }

    /** The swerve drive; null if there is none. */
    val drive: SwerveDrive? by lazy { SwerveDrive.of(view) }

    val xAxis: XAxis = view.xAxis

    /** The events of all event logs, ordered by x. */
    val events: EventTimeline = EventTimeline.of(view.folders.flatMap { it.eventLogs })

    /** The findings so far. Code that changes it must redraw. */
    var findings: FindingTimeline<Finding> = timelineOf(emptyList())

    private var searched: Pair<FindingTimeline<Finding>, Set<String>>? = null

    /** Returns the searchable traits that the topic [name] has because of the findings. */
    fun findingsTraits(name: String): Set<Trait> {
        val known = searched?.takeIf { it.first === findings }
            ?: (findings to findings.worstFirst.flatMapTo(HashSet()) { it.evidence }).also { searched = it }
        return if (name in known.second) setOf(Trait.FINDING) else emptySet()
    }

    /**
     * Returns all traits of [line] that [query] can search for. Returns none if it searches only for names, because some traits require
     * reading all samples.
     */
    fun traitsOf(line: GraphSeries, query: Query): Set<Trait> =
        if (Trait.entries.any(query::asksFor)) line.traits + findingsTraits(line.topic.name) else emptySet()

    /** The notes about moments, ordered by x. */
    var notes: List<Note> = emptyList()

    /** The logs that every graph draws besides this one. */
    var compared: List<ComparedLog> = emptyList()

    /** The name under which this log is shown beside the [compared] ones. */
    var openName: String = ""

    /** The field on which paths are drawn. */
    var field: Field = Field.PLAIN

    val range: VisibleRange = store.range
    val cursor: Cursor = store.cursor

    /** The place of the last finding that a person went to; null if there was none. */
    val visited: FindingPlace<Finding>? get() = store.place.visited
    val sharedY: SharedY = SharedY(board, range) { compared }

    /** The lines and paths that graphs of y over x can draw. */
    val paths: LogPaths by lazy { LogPaths(view, field) { board.lines[it] } }

    /** The spans in which the robot was enabled. */
    val enabled: List<EnabledSpan> = view.enabledSpans()

    /** The formatter for times of the log. */
    val times: LogTimes = LogTimes(range.full.width, xAxis, enabled)

    /** The modes of the robot over time. */
    val modes: ModeTimeline by lazy { ModeTimeline.of(view) }

    /** The marks that every graph shows besides its lines. */
    val marks: PlotMarks get() = PlotMarks(modes, events, findings, notes.map { it.x })

    /** The clocks besides the x axis. */
    val clocks: Clocks by lazy { Clocks(view, modes) }

    /** Returns the name of the finding that a person went to at [x]; null if there is none. */
    fun visitedAt(x: Double): FindingName? = visited?.takeIf { it.span.from == x }?.let { FindingName.of(it.finding) }

    /** Returns the last event at or before [x], with the precision of a pixel; null before the first. */
    fun lastEventAt(x: Double): Event? = events.lastBefore(x + range.now.width * ONE_PIXEL)

    /** Returns the findings under the cursor at [x]: first the one to which the cursor was moved, then the worst. */
    fun findingsAt(x: Double): List<Finding> {
        val all = findings.at(x, range.now.width * MARK_REACH)
        val here = visited?.takeIf { it.span.from == x }?.finding ?: return all
        return listOf(here) + (all - here)
    }

    private var pointed: Pair<List<Any?>, MarksAtCursor>? = null

    /** Returns the marks under the cursor at [x], computed once for all graphs that show them. */
    fun pointedAt(x: Double): MarksAtCursor {
        val asked = listOf(x, range.now, findings, visited, notes)
        pointed?.takeIf { it.first == asked }?.let { return it.second }
        val found = findingsAt(x)
        return MarksAtCursor(markNear(x, range.now, notes, events)?.text, found.firstOrNull()?.severity, findingText(found, x))
            .also { pointed = asked to it }
    }

    /** Returns the findings of [findingsAt] that begin no earlier than the last event at or before [x]. */
    fun newsAt(x: Double): List<Finding> {
        val last = lastEventAt(x) ?: return findingsAt(x)
        val from = last.x - range.now.width * MARK_REACH
        return findingsAt(x).filter { finding -> finding.places.any { it.from >= from } }
    }

    /** Moves the cursor to [x], and scrolls the visible range there if necessary. */
    fun goTo(x: Double) {
        if (xAxis.range != null) store.send(PlaceAction.GoTo(x))
    }

    /** Returns a place on the x axis as text, with the precision of the screen and the unit of x. */
    fun xText(x: Double): String = withUnit(xNumber(x), xAxis.unit)

    /** Returns the same as [xText], without the unit. */
    fun xNumber(x: Double): String = placeText(x, xAxis, range.now.width)
}

/**
 * The visible values in all graphs of [board] that share their y limits. A graph need not be on the screen.
 *
 * @param compared returns the logs that the graphs draw besides the page's own.
 */
internal class SharedY(private val board: PageBoard, private val range: VisibleRange, private val compared: () -> List<ComparedLog>) {
    private val curves = HashMap<GraphSeries, Curve>()
    private val columns = PixelColumns(COLUMNS)
    private var curvesOf: Pair<BoardLines, List<ComparedLog>>? = null
    private var seenOf: Pair<Board, Span>? = null

    /** The visible values of each unit. */
    var seen: Map<String, SeenOfUnit> = emptyMap()
        private set
        get() {
            val now = board.now to range.now
            val logs = board.lines to compared()
            if (now != seenOf || logs != curvesOf) {
                seenOf = now
                if (logs != curvesOf) curves.clear()
                curvesOf = logs
                val names = board.now.graphs.filter { it.sharesY }.flatMap { it.lines - it.hidden }.distinct()
                field = seenTogether(names.flatMap { name -> (listOf(board.lines[name]) + logs.second.map { it[name] }).mapNotNull(::see) })
            }
            return field
        }

    private fun see(line: GraphSeries?): SeenOfUnit? {
        if (line == null || line.states != null) return null
        val curve = curves.getOrPut(line) { Curve(line.data, line.holdsUntil) }
        curve.draw(range.now.from, range.now.to, columns)
        return SeenOfUnit(unitText(line.unit), curve.min, curve.max)
    }
}

/**
 * The note, event and findings under a cursor.
 *
 * @property said the text of the note there, otherwise of the event; null if there is neither.
 * @property severity the severity of the first finding there; null if there is none.
 * @property found the text of the findings; empty if there are none.
 */
internal class MarksAtCursor(val said: String?, val severity: Severity?, val found: String)

/** The precision of a mouse, as a fraction of the screen's width. Without it, the last event could not be reached. */
private const val ONE_PIXEL = 0.002

private const val COLUMNS = 500
