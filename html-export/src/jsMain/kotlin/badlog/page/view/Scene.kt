package badlog.page.view

import badlog.analysis.EnabledSpan
import badlog.analysis.Event
import badlog.analysis.GraphSeries
import badlog.analysis.LogView
import badlog.analysis.XAxis
import badlog.analysis.enabledSpans
import badlog.html.note.Note
import badlog.plot.address.FindingName
import badlog.plot.outline.traits
import badlog.plot.path.Field
import badlog.plot.range.Viewport
import badlog.plot.search.Query
import badlog.plot.search.Trait
import badlog.plot.text.placeText
import badlog.plot.text.withUnit
import badlog.plot.timeline.Clocks
import badlog.plot.timeline.EventTimeline
import badlog.plot.timeline.FindingPlace
import badlog.plot.timeline.FindingTimeline
import badlog.plot.timeline.ModeTimeline
import badlog.rules.Finding
import badlog.rules.path.Pose
import badlog.rules.path.posesOf
import kotlin.math.abs

/** What all parts of the page share: the recording, what was found in it, what of it is seen, the cursor, and the [board]. */
internal class Scene(val view: LogView, val fileName: String, val palette: Palette, val board: PageBoard, val notice: Notice) {
    val xAxis: XAxis = view.xAxis
    val events: EventTimeline = EventTimeline.of(view.folders.flatMap { it.eventLogs })

    /** What was found so far. Whoever changes it draws again. */
    var findings: FindingTimeline<Finding> = timelineOf(emptyList())

    private var searched: Pair<FindingTimeline<Finding>, Set<String>>? = null

    /** What a search can ask of the topic [name] because of what was found. */
    fun findingsTraits(name: String): Set<Trait> {
        val known = searched?.takeIf { it.first === findings }
            ?: (findings to findings.worstFirst.flatMapTo(HashSet()) { it.evidence }).also { searched = it }
        return if (name in known.second) setOf(Trait.FINDING) else emptySet()
    }

    /** All that [query] can ask of [line]; nothing where it asks for names alone, for some of it takes a look at all samples. */
    fun traitsOf(line: GraphSeries, query: Query): Set<Trait> =
        if (Trait.entries.any(query::asksFor)) line.traits + findingsTraits(line.topic.name) else emptySet()

    /** What people wrote about moments, in the order of x. */
    var notes: List<Note> = emptyList()

    /** Where a person went last to look at a finding; null before. */
    var visited: FindingPlace<Finding>? = null
        set(value) {
            field = value
            // Perhaps another one at the same place.
            cursor.announce()
        }

    /** The field that paths are drawn on. */
    var field: Field = Field.PLAIN

    val range: VisibleRange = VisibleRange(Viewport.of(xAxis.range))
    val cursor: Cursor = Cursor(xAxis.clocks)
    val sharedY: SharedY = SharedY(board, range)

    /** The poses that its topics tell. */
    val poses: List<Pose> by lazy { posesOf(view.recording.topics) }

    /** When the robot was enabled. */
    val enabled: List<EnabledSpan> by lazy { view.enabledSpans() }

    /** The note that is pointed at when the cursor is at [x], or null. */
    fun noteAt(x: Double): Note? = notes.minByOrNull { abs(it.x - x) }?.takeIf { abs(it.x - x) <= range.now.width * REACH }

    /** When it was in which mode. */
    val modes: ModeTimeline by lazy { ModeTimeline.of(view) }

    /** The clocks besides the x axis. */
    val clocks: Clocks by lazy { Clocks(view, modes) }

    /** What the finding is called that a person went to at [x]; null where nobody did. */
    fun visitedAt(x: Double): FindingName? = visited?.takeIf { it.span.from == x }?.let { FindingName.of(it.finding) }

    /** The event that is pointed at when the cursor is at [x], or null. */
    fun eventAt(x: Double): Event? = events.nearest(x, range.now.width * REACH)

    /** The last event at or before [x], as exactly as a pixel is; null before the first. */
    fun lastEventAt(x: Double): Event? = events.lastBefore(x + range.now.width * ONE_PIXEL)

    /** The findings that are pointed at when the cursor is at [x]: the one that it was taken to, then the worst first. */
    fun findingsAt(x: Double): List<Finding> {
        val all = findings.at(x, range.now.width * REACH)
        val here = visited?.takeIf { it.span.from == x }?.finding ?: return all
        return listOf(here) + (all - here)
    }

    private var pointed: Pair<List<Any?>, Pointed>? = null

    /** What is pointed at when the cursor is at [x], worked out once for all graphs that show it. */
    fun pointedAt(x: Double): Pointed {
        val asked = listOf(x, range.now, findings, visited)
        pointed?.takeIf { it.first == asked }?.let { return it.second }
        val found = findingsAt(x)
        return Pointed(noteAt(x)?.text ?: eventAt(x)?.text, found.firstOrNull()?.severity, findingText(found, x))
            .also { pointed = asked to it }
    }

    /** Those of [findingsAt] that did not begin before the last event at or before [x]: that is the news then. */
    fun newsAt(x: Double): List<Finding> {
        val last = lastEventAt(x) ?: return findingsAt(x)
        val from = last.x - range.now.width * REACH
        return findingsAt(x).filter { finding -> finding.places.any { it.from >= from } }
    }

    /** Takes the cursor to [x], and the view where that is out of sight. */
    fun goTo(x: Double) {
        if (!x.isFinite() || xAxis.range == null) return
        val place = x.coerceIn(range.full.from, range.full.to)
        range.change { revealing(place) }
        cursor.change { pinnedAt(place) }
    }

    /** Shows what is around [from] to [to], and takes the cursor to [from]. */
    fun zoomTo(from: Double, to: Double) {
        if (!from.isFinite()) return
        range.change { around(from, to) }
        goTo(from)
    }

    /** A place on the x axis as text, as exact as the screen is, with the unit of x. */
    fun xText(x: Double): String = withUnit(xNumber(x), xAxis.unit)

    /** The same without the unit. */
    fun xNumber(x: Double): String = placeText(x, xAxis, range.now.width)

    private companion object {
        /** Which part of the screen's width may lie between the cursor and what it points at. */
        const val REACH = 0.008

        /** The part of the screen's width that a mouse cannot do better than: else the last event could not be met. */
        const val ONE_PIXEL = 0.002
    }
}
