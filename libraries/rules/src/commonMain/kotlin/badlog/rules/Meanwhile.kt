package badlog.rules

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.signals.NamedSamples
import badlog.signals.NamedSignal

/**
 * A signal that was unusual while a rule held.
 *
 * @property signal its name.
 * @property title its name, or its topic's if others have the same name.
 * @property most the largest value while the rule held.
 * @property usual the median of the log; [most] is more than twice as large.
 */
internal class Meanwhile(val signal: String, val title: String, val most: Double, val usual: Double, val unit: String)

/**
 * Returns the [others] that rose during [spans]. They rose to more than twice their usual value, during nearly each span or just before,
 * and hardly ever elsewhere. This shows coincidence, not cause.
 */
internal fun unusualWithin(spans: List<Span>, others: List<NamedSignal>, samples: NamedSamples): List<Meanwhile> {
    if (spans.isEmpty()) return emptyList()
    return others.mapNotNull { other ->
        val series = samples.of(other)
        val usual = if (series.isOrdered) medianOf(series) else Double.NaN
        if (!(usual > 0) || rareness(series, usual) > RARE) return@mapNotNull null
        val most = spans.map { span -> mostIn(series, span.from - BEFORE_SECONDS, span.to + AFTER_SECONDS) }
        val isEachTime = most.count { it > TIMES * usual } >= MAX_SPANS * spans.size
        val title = if (others.count { it.name == other.name } > 1) other.topics[0] else other.name
        if (isEachTime) Meanwhile(other.name, title, most.max(), usual, other.listed.unit) else null
    }
}

private fun rareness(series: Series, usual: Double) = series.y.count { it > TIMES * usual }.toDouble() / series.size

private fun mostIn(series: Series, from: Double, to: Double): Double {
    var most = 0.0
    for (i in series.x.indices) if (series.x[i] in from..to && series.y[i] > most) most = series.y[i]
    return most
}

private fun medianOf(series: Series): Double = series.y.filter { it.isFinite() }.sorted().let { it.getOrElse(it.size / 2) { Double.NaN } }

private const val TIMES = 2.0

/** Of the times at which the rule held, and of all samples. */
private const val MAX_SPANS = 0.8
private const val RARE = 0.02
private const val BEFORE_SECONDS = 0.3
private const val AFTER_SECONDS = 0.1
