package badlog.cli.pack

import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.expression.LogViewSignals
import badlog.expression.signals.SignalKind
import java.math.RoundingMode
import kotlin.math.abs
import kotlin.math.log10
import kotlin.math.max
import kotlin.math.roundToInt

/**
 * Returns a condition that is true at [moment] of [view] and nowhere outside [around]. If there is none, one that is true nowhere else in
 * [around]. It is about the topic that differs most from its other samples, with a limit halfway between them. It is only a first draft for
 * a person to change. Null if no topic has an unusual value at the moment.
 *
 * @param near the distance from [moment] up to which a sample belongs to it.
 */
internal fun conditionAt(view: LogView, moment: Double, around: Span, near: Double): String? {
    val signals = LogViewSignals(view)
    val time = Span(moment - near, moment + near)
    val topics = signals.vocabulary.signals.filter { it.name != view.xAxis.topic?.name }
    fun best(isOther: (Double) -> Boolean): String? = topics.mapNotNull { signal ->
        val quoted = "\"${signal.name.replace("\"", "\"\"")}\""
        when (signal.kind) {
            SignalKind.NUMBER -> MomentSamples(signals.series(signal.name), time, isOther).limit(quoted)
            SignalKind.CONDITION -> MomentSamples(signals.series(signal.name), time, isOther).truth(quoted)
            else -> null
        }
    }.maxByOrNull { it.distance }?.text
    return best { it !in around.from..around.to } ?: best { it in around.from..around.to }
}

/**
 * A condition about a topic.
 *
 * @property distance the distance of the moment's samples from the others, as a share of the others' range.
 */
private class MomentLimit(val text: String, val distance: Double)

/** The samples of [series] within [moment], and the samples at other times that fulfill [isOther]. */
private class MomentSamples(series: Series, moment: Span, isOther: (Double) -> Boolean) {
    private val own = ArrayList<Double>()
    private val others = ArrayList<Double>()

    init {
        for (i in 0 until series.size) {
            val x = series.x[i]
            if (!series.y[i].isFinite()) continue
            if (x in moment.from..moment.to) {
                own += series.y[i]
            } else if (isOther(x)) {
                others += series.y[i]
            }
        }
    }

    /** Returns a condition for [topic] with numbers; null if the moment's numbers are not set apart. */
    fun limit(topic: String): MomentLimit? {
        if (own.isEmpty() || others.size < MIN_SAMPLES) return null
        val below = others.min() - own.min()
        val above = own.max() - others.max()
        val gap = max(below, above)
        // A topic that hardly ever changes has no range to compare with.
        val range = max(others.max() - others.min(), max(abs(others.max()), abs(others.min())) * MIN_RANGE)
        if (range == 0.0 || gap < range * MIN_GAP) return null
        val limit = if (below >= above) others.min() - gap / 2 else others.max() + gap / 2
        return MomentLimit("$topic ${if (below >= above) "<" else ">"} ${plain(limit, gap)}", gap / range)
    }

    /** Returns a condition for [topic] with truth values; null if the moment's values are not set apart. */
    fun truth(topic: String): MomentLimit? {
        val isSteady = others.size >= MIN_SAMPLES && others.all { it == others[0] }
        if (!isSteady || own.all { it == others[0] }) return null
        return MomentLimit(if (others[0] == 0.0) topic else "not $topic", TRUTH_DISTANCE)
    }

    /** Returns [limit] with only as many digits as its place within [gap] needs. */
    private fun plain(limit: Double, gap: Double): String {
        var step = 1.0
        while (step > gap / 4) step /= 10
        while (step * 10 <= gap / 4) step *= 10
        val digits = max(0, -log10(step).roundToInt())
        return limit.toBigDecimal().setScale(digits, RoundingMode.HALF_EVEN).toPlainString()
    }
}

private const val MIN_SAMPLES = 10
private const val MIN_GAP = 0.1
private const val MIN_RANGE = 0.05

/** A condition says less than a number far from all others. */
private const val TRUTH_DISTANCE = 1.0
