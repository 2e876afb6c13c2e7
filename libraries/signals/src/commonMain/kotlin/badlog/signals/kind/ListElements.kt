package badlog.signals.kind

import badlog.core.analysis.Series
import badlog.expression.signals.Signals

/**
 * Which topics of [log] are elements of lists: of arrays whose length changes, such as queues of odometry, paths, and tags in sight. The
 * last elements of such an array come and go, and the first mean something else each time, so none of them is a sensor.
 */
class ListElements(private val log: Signals) {
    private val arrays: Map<String, List<String>> by lazy {
        log.vocabulary.signals.map { it.name }.filter { '[' in it }.groupBy(::arrayOf)
    }
    private val known = HashMap<String, Boolean>()

    /** Returns whether [topic] is one. */
    operator fun contains(topic: String): Boolean = '[' in topic && known.getOrPut(arrayOf(topic)) { changes(arrayOf(topic)) }

    private fun changes(array: String): Boolean {
        val elements = arrays[array].orEmpty().map(log::series)
        return elements.any { it.size != elements[0].size || hasGap(it) }
    }

    private fun hasGap(series: Series) = series.y.any { it.isNaN() }

    private fun arrayOf(topic: String) = topic.substringBefore('[')
}
