package badlog.signals.clock

import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.analysis.enabledSpans

/**
 * A moment at which the robot was enabled or disabled.
 *
 * @property seconds the time, in s on the clock of its log.
 * @property isRise whether it was enabled then, rather than disabled.
 */
class EnabledEdge(val seconds: Double, val isRise: Boolean)

/**
 * Returns the moments at which the robot was enabled and disabled, at most the first [MAX_EDGES]. The log's own start and end are left out.
 * Empty if the log does not show it.
 */
fun LogView.enabledEdges(): List<EnabledEdge> {
    val range = xAxis.range ?: return emptyList()
    val spans = enabledSpans().map { it.span }
    val begins = spans.mapTo(HashSet()) { it.from }
    val ends = spans.mapTo(HashSet()) { it.to }
    return spans.flatMap { span ->
        listOfNotNull(
            span.from.takeIf { it > range.start && it !in ends }?.let { EnabledEdge(it * secondsPerX, true) },
            span.to.takeIf { it < range.endInclusive && it !in begins }?.let { EnabledEdge(it * secondsPerX, false) },
        )
    }.take(MAX_EDGES)
}

/** The number of seconds per unit of x; any unit that is not a time counts as a second. */
val LogView.secondsPerX: Double get() = Units.secondsIn(xAxis.unit) ?: 1.0

private const val MAX_EDGES = 200
