package badlog.viewer.inspector

import badlog.analysis.EventLog
import badlog.viewer.text.wordsOf

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
