package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.max

/**
 * Returns the time for which a device with the topics [sent] sent nothing, in s. It is the length of the gap during each gap, otherwise 0.
 * Only gaps count in which the robot was enabled and more than half of [others] sent something. Empty if there are too few samples, or if
 * the log keeps changes only: then silence means that nothing changed.
 */
fun busSilence(sent: List<Series>, others: List<Series>, isEnabled: (Double) -> Boolean): Series {
    val own = sent.map(::known).maxByOrNull { it.size }
    if (own == null || own.size < MIN_SAMPLES || sent.none(::repeats)) return Series(DoubleArray(0), DoubleArray(0))
    val end = others.maxOfOrNull { if (it.size == 0) 0.0 else it.x[it.size - 1] } ?: 0.0
    val usual = quantile(DoubleArray(own.size - 1) { own.x[it + 1] - own.x[it] }, 0.5)
    val least = max(MIN_SECONDS, usual * USUAL_GAPS)
    val times = arrayListOf(own.x[0])
    val gaps = arrayListOf(0.0)
    for (i in 0 until own.size) {
        val from = own.x[i]
        val to = if (i + 1 < own.size) own.x[i + 1] else end
        if (to - from < least || !isEnabled(from) || !isEnabled(from + least)) continue
        val sending = others.count { it.firstAtOrAfter(to - usual) - it.firstAtOrAfter(from + usual) > 1 }
        if (2 * sending <= others.size) continue
        times += from
        gaps += to - from
        times += to
        gaps += 0.0
    }
    return Series(times.toDoubleArray(), gaps.toDoubleArray())
}

/** Returns [series] without its gaps: in a log of rows, a device that sends nothing leaves cells empty. */
private fun known(series: Series): Series {
    val kept = (0 until series.size).filter { series.y[it].isFinite() }
    return if (kept.size == series.size) {
        series
    } else {
        Series(DoubleArray(kept.size) { series.x[kept[it]] }, DoubleArray(kept.size) { series.y[kept[it]] })
    }
}

private fun repeats(series: Series) = (1 until series.size).count { series.y[it] == series.y[it - 1] } > REPEATS * series.size

private const val REPEATS = 0.05
private const val MIN_SAMPLES = 100
private const val MIN_SECONDS = 0.3
private const val USUAL_GAPS = 12
