package badlog.viewer.recording

import badlog.analysis.Event
import badlog.analysis.EventLog
import badlog.analysis.Series
import badlog.analysis.Span
import badlog.viewer.text.wordsOf
import kotlin.math.abs

/** The events of all [logs] of a recording, put in the order of x once and filtered as often as a person types. */
internal class RecordingEvents(private val logs: List<EventLog>) {
    /** All of them. Of several at the same x those of an earlier log come first, and those of one log as they were logged. */
    val all: MatchingEvents = inOrder(logs)

    /** Those that [filter] lets through. */
    fun matching(filter: EventFilter): MatchingEvents {
        if (filter.isOff) return all
        val words = wordsOf(filter.text)
        val topics = filter.topicsOf(logs)
        // Each different text is looked at once, however often it was logged.
        val fits = logs.map { log ->
            val isWanted = topics.isEmpty() || log.name in topics
            val texts = log.topic.texts.dictionary
            BooleanArray(texts.size) {
                isWanted && words.all { word -> texts[it].contains(word, true) || log.name.contains(word, true) }
            }
        }
        return all.filtered { fits[all.logOf[it]][logs[all.logOf[it]].topic.texts.ids[all.cellOf(it)]] }
    }
}

private fun inOrder(logs: List<EventLog>): MatchingEvents {
    val count = logs.sumOf { it.topic.texts.size }
    val x = DoubleArray(count)
    val logOf = IntArray(count)
    val cells = IntArray(count)
    var next = 0
    logs.forEachIndexed { log, events ->
        for (cell in 0 until events.topic.texts.size) {
            val place = events.events[cell].x
            x[next] = if (place.isFinite()) place else Double.NaN
            logOf[next] = log
            cells[next++] = cell
        }
    }
    val order = orderOf(x)
    return MatchingEvents(
        DoubleArray(count) { x[order[it]] },
        logs,
        IntArray(count) { logOf[order[it]] },
        IntArray(count) { cells[order[it]] },
    )
}

/** The indexes of [x] from the smallest to the largest, equal ones as they stand, NaN last: a merge sort of plain numbers. */
internal fun orderOf(x: DoubleArray): IntArray {
    var from = IntArray(x.size) { it }
    var into = IntArray(x.size)
    var width = 1
    while (width < x.size) {
        for (start in 0 until x.size step width * 2) {
            var left = start
            val middle = minOf(start + width, x.size)
            var right = middle
            val end = minOf(start + width * 2, x.size)
            for (i in start until end) {
                val takesLeft = left < middle && (right >= end || x[from[left]].compareTo(x[from[right]]) <= 0)
                into[i] = if (takesLeft) from[left++] else from[right++]
            }
        }
        from = into.also { into = from }
        width *= 2
    }
    return from
}

/**
 * Events of several topics in the order of x, without an object for each. Those without an x come last.
 *
 * @property x where each stands; NaN where the x axis has a gap. Not to be changed.
 * @property logs the event logs they come from.
 * @property logOf for each event the place of its log in [logs]. Not to be changed.
 * @property placedCount how many have an x; they are the first ones.
 */
internal class MatchingEvents(val x: DoubleArray, val logs: List<EventLog>, val logOf: IntArray, private val cells: IntArray) {
    /** How many there are. */
    val size: Int get() = x.size

    val placedCount: Int = x.size - x.count { it.isNaN() }

    private val places = Series(x.copyOf(placedCount), DoubleArray(placedCount))

    /** Event [index], made anew. */
    fun eventAt(index: Int): Event = logs[logOf[index]].events[cells[index]]

    /** The text of event [index]. */
    fun textOf(index: Int): String = logs[logOf[index]].topic.texts[cells[index]]

    /** The full name of the topic of event [index]. */
    fun topicOf(index: Int): String = logs[logOf[index]].name

    /** The first event at or after [position]; [placedCount] when there is none. */
    fun firstAtOrAfter(position: Double): Int = places.firstAtOrAfter(position)

    /** The event nearest to [position]; -1 when none has an x. */
    fun nearest(position: Double): Int = places.nearest(position)

    /** The event nearest to [position] if it is no further than [distance], else null. */
    fun nearest(position: Double, distance: Double): Event? =
        nearest(position).takeIf { it >= 0 && abs(x[it] - position) <= distance }?.let(::eventAt)

    /**
     * The pixels, ascending, of [width] that show [span], on which events stand. Costs as much as there are pixels, however many
     * events there are.
     */
    fun pixels(span: Span, width: Int): IntArray {
        val pixels = IntArray(minOf(width + 1, placedCount))
        var count = 0
        var index = firstAtOrAfter(span.from)
        while (index < placedCount && x[index] <= span.to && count < pixels.size) {
            val pixel = ((x[index] - span.from) / span.width * width).toInt()
            // What was skipped to may be this pixel again, by rounding.
            if (count == 0 || pixels[count - 1] != pixel) pixels[count++] = pixel
            index = maxOf(index + 1, firstAtOrAfter(span.from + (pixel + 1) * span.width / width))
        }
        return pixels.copyOf(count)
    }

    /** Those that [keep] wants, by their index. */
    fun filtered(keep: (Int) -> Boolean): MatchingEvents {
        val kept = IntArray(size)
        var count = 0
        for (i in 0 until size) if (keep(i)) kept[count++] = i
        if (count == size) return this
        return MatchingEvents(
            DoubleArray(count) { x[kept[it]] },
            logs,
            IntArray(count) { logOf[kept[it]] },
            IntArray(count) { cells[kept[it]] },
        )
    }

    /** Which cell of its topic's texts event [index] is. */
    internal fun cellOf(index: Int): Int = cells[index]

    companion object {
        /** No events. */
        val NONE = MatchingEvents(DoubleArray(0), emptyList(), IntArray(0), IntArray(0))
    }
}

/**
 * Which events are listed and marked.
 *
 * @property text words that the text or the topic of an event must contain, regardless of case; empty for any.
 * @property topics the names of the topics whose events count; empty, or of other recordings, for all.
 */
internal data class EventFilter(val text: String = "", val topics: Set<String> = emptySet()) {
    /** Whether it lets everything through. */
    val isOff: Boolean get() = text.isBlank() && topics.isEmpty()

    /** Those of [topics] that are among [logs]: a filter stays when another recording is opened, which may have none of them. */
    fun topicsOf(logs: List<EventLog>): Set<String> = logs.mapNotNullTo(HashSet()) { log -> log.name.takeIf { it in topics } }

    /** Adds [topic] to [topics], or takes it out. */
    fun toggled(topic: String): EventFilter = copy(topics = if (topic in topics) topics - topic else topics + topic)
}
