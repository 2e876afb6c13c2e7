package badlog.signals.kind

import badlog.core.analysis.Series
import badlog.expression.signals.Signals

/**
 * The topics of [log] that are elements of lists: of arrays with a changing length, such as queues of odometry, paths, and tags in sight. The last
 * elements of such an array come and go, and the first mean something else each time, so none of them is a sensor.
 */
class ListElements(private val log: Signals) {
    private val arrays: Map<String, List<String>> by lazy {
        log.vocabulary.signals.map { it.name }.filter { '[' in it }.groupBy(::arrayOf)
    }
    private val known = HashMap<String, Boolean>()

    /** Returns whether [topic] is an element of a list. */
    operator fun contains(topic: String): Boolean = '[' in topic && known.getOrPut(arrayOf(topic)) { isList(arrayOf(topic)) }

    /**
     * Returns whether [array] is a list. A list is empty at times, or loses its last elements first, and repeatedly. A sensor that is lost is a
     * single element, or is lost once.
     */
    private fun isList(array: String): Boolean {
        val elements = arrays[array].orEmpty().sortedBy(::indexOf).map(log::series)
        if (isEmptyAtTimes(elements)) return true
        if (elements.none { changes(it) >= FEWEST_CHANGES }) return false
        return (1 until elements.size).all { at -> isShorter(elements[at - 1], elements[at]) }
    }

    private fun isEmptyAtTimes(elements: List<Series>): Boolean {
        val size = elements[0].size
        return elements.all { it.size == size } && (0 until size).any { at -> elements.all { it.y[at].isNaN() } }
    }

    private fun changes(element: Series): Int {
        val isEmptyFirst = element.size > 0 && element.y[0].isNaN()
        return (1 until element.size).count { element.y[it].isNaN() != element.y[it - 1].isNaN() } + if (isEmptyFirst) 1 else 0
    }

    /** Returns whether [element] is missing wherever the one [before] it is. */
    private fun isShorter(before: Series, element: Series) =
        before.size != element.size || (0 until before.size).none { before.y[it].isNaN() && !element.y[it].isNaN() }

    private fun indexOf(topic: String) = topic.substringAfter('[').substringBefore(']').toIntOrNull() ?: 0

    /** Returns the common name of an array's elements, without their index. */
    private fun arrayOf(topic: String) = topic.substringBefore('[') + "[]" + topic.substringAfter(']')

    private companion object {
        /** The least number of times that an element comes or goes; the start counts if it is missing first. */
        const val FEWEST_CHANGES = 3
    }
}
