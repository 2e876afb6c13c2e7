package badlog.signals.derived

import badlog.core.analysis.Series

/**
 * Returns the value of this series at each of [times], which ascend. It is the last sample at or before that time; NaN before the first.
 */
fun Series.heldAt(times: DoubleArray): DoubleArray {
    var next = 0
    return DoubleArray(times.size) { i ->
        while (next < size && x[next] <= times[i]) next++
        if (next == 0) Double.NaN else y[next - 1]
    }
}

/** Returns the times of all [series], ascending, each once. */
fun timesOf(series: List<Series>): DoubleArray {
    val first = series[0].x
    if (series.all { it.x === first }) return first
    val all = series.flatMap { it.x.asIterable() }.toDoubleArray().apply { sort() }
    var kept = 0
    for (time in all) if (kept == 0 || time > all[kept - 1]) all[kept++] = time
    return all.copyOf(kept)
}

/**
 * Returns the times of all [series], with additional times between those that are more than [step] apart. A log of changes has no sample
 * while nothing changes.
 */
internal fun steppedTimes(series: List<Series>, step: Double): DoubleArray {
    val own = timesOf(series)
    val all = ArrayList<Double>(own.size)
    for (time in own) {
        val before = all.lastOrNull() ?: time
        val between = minOf(((time - before) / step).toInt(), MAX_BETWEEN)
        for (k in 1..between) if (before + k * step < time) all += before + k * step
        all += time
    }
    return all.toDoubleArray()
}

/** A pause of minutes shows nothing. */
private const val MAX_BETWEEN = 600

/** Returns [values] times [scale]. */
internal fun scaled(values: DoubleArray, scale: Double): DoubleArray = DoubleArray(values.size) { values[it] * scale }

/** Returns the percentile at [share], a fraction from 0 to 1, of the finite numbers in [values]; NaN if there are none. */
internal fun quantile(values: DoubleArray, share: Double): Double {
    val sorted = values.filter { it.isFinite() }.toDoubleArray().apply { sort() }
    return if (sorted.isEmpty()) Double.NaN else sorted[((sorted.size - 1) * share).toInt()]
}

/** Returns the smallest index with a time at most [seconds] before the time of [at]. */
internal fun indexBefore(times: DoubleArray, at: Int, seconds: Double, from: Int = 0): Int {
    var low = from
    var high = at
    while (low < high) {
        val middle = (low + high) ushr 1
        if (times[middle] < times[at] - seconds) low = middle + 1 else high = middle
    }
    return low
}
