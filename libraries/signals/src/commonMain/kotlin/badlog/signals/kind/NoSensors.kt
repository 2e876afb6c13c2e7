package badlog.signals.kind

import badlog.core.analysis.Series
import badlog.expression.signals.Signals

/**
 * The topics of [log] that no sensor measured, despite their names. These are sizes of undecoded records, lengths of arrays, and elements
 * of lists. Lists are arrays with a changing length, such as queues of odometry, paths, and tags in sight. The last elements of such an
 * array come and go, and the first mean something else each time.
 *
 * An export by AdvantageScope calls elements `name/0` or `name/0/value`, and their number `name/length`; elements beyond that number keep old values.
 */
class NoSensors(private val log: Signals) {
    private val arrays: Map<String, List<String>> by lazy {
        log.vocabulary.signals.map { it.name }.filter { '[' in it }.groupBy(::arrayOf)
    }
    private val known = HashMap<String, Boolean>()
    private val sizes by lazy { log.vocabulary.signals.filter { it.unit == "B" }.mapTo(HashSet()) { it.name } }
    private val exported: Set<String> by lazy {
        val lengths = log.vocabulary.signals.map { it.name }.filter { it.endsWith(LENGTH) && changes(log.series(it)) }
        lengths.mapTo(HashSet()) { it.removeSuffix(LENGTH) }
    }

    /** Returns whether [topic] is one of these. */
    operator fun contains(topic: String): Boolean = topic in sizes || topic.endsWith(LENGTH) || isExported(topic) ||
        ('[' in topic && known.getOrPut(arrayOf(topic)) { isList(arrayOf(topic)) })

    private fun isExported(topic: String) =
        topic.indices.any { topic[it] == '/' && topic.getOrNull(it + 1) in '0'..'9' && topic.substring(0, it) in exported }

    private fun changes(length: Series) = length.y.any { it != length.y[0] }

    /**
     * Returns whether [array] is a list. A list is empty at times, or loses its last elements first, and repeatedly. A sensor that is lost is a
     * single element, or is lost once.
     */
    private fun isList(array: String): Boolean {
        val elements = arrays[array].orEmpty().sortedBy(::indexOf).map(log::series)
        if (isEmptyAtTimes(elements)) return true
        if (elements.none { comings(it) >= MIN_CHANGES }) return false
        return (1 until elements.size).all { at -> isShorter(elements[at - 1], elements[at]) }
    }

    private fun isEmptyAtTimes(elements: List<Series>): Boolean {
        val size = elements[0].size
        return elements.all { it.size == size } && (0 until size).any { at -> elements.all { it.y[at].isNaN() } }
    }

    private fun comings(element: Series): Int {
        val isEmptyFirst = element.size > 0 && element.y[0].isNaN()
        return (1 until element.size).count { element.y[it].isNaN() != element.y[it - 1].isNaN() } + if (isEmptyFirst) 1 else 0
    }

    /** Returns whether [element] is missing wherever the one [before] it is. */
    private fun isShorter(before: Series, element: Series) =
        before.size != element.size || (0 until before.size).none { before.y[it].isNaN() && !element.y[it].isNaN() }

    private fun indexOf(topic: String) = topic.substringAfter('[').substringBefore(']').toIntOrNull() ?: 0

    /** Returns the common name of an array's elements, without their index. */
    private fun arrayOf(topic: String) = topic.substringBefore('[') + "[]" + topic.substringAfter(']')
}

/** The least number of times that an element comes or goes; the start counts if it is missing first. */
private const val MIN_CHANGES = 3
private const val LENGTH = "/length"
