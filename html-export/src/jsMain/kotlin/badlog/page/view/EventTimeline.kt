package badlog.page.view

import badlog.analysis.Event
import badlog.analysis.LogView
import badlog.analysis.Series
import kotlin.math.abs

/** The events of all logs that have a place on the x axis, in its order. */
internal class EventTimeline(view: LogView) {
    /** The events, ascending. */
    val events: List<Event> = view.folders.flatMap { it.eventLogs }.flatMap { it.events }
        .filter { it.x.isFinite() }.sortedBy { it.x }

    private val positions = DoubleArray(events.size) { events[it].x }.let { Series(it, it) }

    private val isSerious by lazy { BooleanArray(events.size) { SERIOUS.containsMatchIn(events[it].text) } }

    /** Whether event [index] calls itself an error or a warning. */
    fun isSerious(index: Int): Boolean = isSerious[index]

    /** The index of the first event at or after [x]. */
    fun firstAtOrAfter(x: Double): Int = positions.firstAtOrAfter(x)

    /** The event nearest to [x] if it is no further than [distance]. */
    fun nearest(x: Double, distance: Double): Event? {
        if (x.isNaN() || events.isEmpty()) return null
        return events[positions.nearest(x)].takeIf { abs(it.x - x) <= distance }
    }

    /** The last event at or before [x]. */
    fun lastBefore(x: Double): Event? {
        var index = positions.firstAtOrAfter(x)
        while (index < events.size && events[index].x == x) index++
        return events.getOrNull(index - 1)
    }

    private companion object {
        /** As logs write it: `ERROR: brownout`, `[warning] …`. */
        val SERIOUS = Regex("^\\W*(error|warn|fatal|severe|critical)", RegexOption.IGNORE_CASE)
    }
}
