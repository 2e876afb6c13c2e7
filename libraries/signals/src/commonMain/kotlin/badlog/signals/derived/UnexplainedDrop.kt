package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.max

/**
 * Returns by how much [battery] is lower than [current] explains, in V; 0 where it is not. It is also 0 in dips with an uncertain current: if its
 * sensor was not read at least twice within them, or is slow.
 *
 * A battery is modeled as a voltage that changes slowly and a resistance, which is fitted to the log. The highest current from [LAG_SECONDS] before
 * to [LATEST_SECONDS] after counts, since sensors lag and a dip may be over before they are read.
 */
fun unexplainedDrop(battery: Series, current: Series): Series {
    val times = battery.x
    if (usualStep(current) > SLOWEST_STEP) return Series(times, DoubleArray(times.size))
    val amperes = current.heldAt(times)
    val resistance = resistanceOf(battery.y, amperes)
    val open = openVolts(times, battery.y, amperes, resistance)
    val dropped = DoubleArray(times.size) { i -> open[i] - resistance * highest(current, times[i]) - battery.y[i] }
    val explained = DoubleArray(times.size)
    var i = 0
    while (i < times.size) {
        if (!(dropped[i] > MIN_VOLTS)) {
            i++
            continue
        }
        var end = i
        while (end < times.size && dropped[end] > MIN_VOLTS) end++
        // A sensor that lags or is slow misses some of the current.
        fun exceedsUnmeasured(from: Int, to: Int) =
            lowest(amperes, from, to) < MAX_AMPERES && (from until to).maxOf { dropped[it] } > UNMEASURED_AMPERES * resistance
        val until = if (end < times.size) times[end] else times[end - 1]
        val isDip = until - times[i] <= LONGEST_SECONDS && i > 0 && end < times.size
        // A load that begins with the dip explains more than a sensor that lags shows of it.
        val isLoad = i > 0 && (i until end).maxOf { amperes[it] } > amperes[i - 1] + LOAD_AMPERES
        if (isDip && !isLoad && readsWithin(current, times[i], until) >= MIN_READS && exceedsUnmeasured(i, end)) {
            for (k in i until end) explained[k] = dropped[k]
        }
        i = end
    }
    return Series(times, explained)
}

/**
 * Returns the resistance in Ω, within the range of batteries: the slope of voltage over current. If the drop from the voltage at rest under high
 * currents shows a larger one, that counts. A sensor that is read a little later than the voltage makes the slope too small.
 */
private fun resistanceOf(volts: DoubleArray, amperes: DoubleArray): Double {
    val resting = quantile(DoubleArray(volts.size) { if (amperes[it] < REST_AMPERES) volts[it] else Double.NaN }, 0.5)
    val loaded = quantile(
        DoubleArray(volts.size) {
            if (amperes[it] >
                HIGH_AMPERES
            ) {
                (resting - volts[it]) / amperes[it]
            } else {
                Double.NaN
            }
        },
        0.5,
    )
    val slope = slopeOf(volts, amperes)
    return (if (loaded > slope) loaded else slope).coerceIn(MIN_OHMS, MAX_OHMS)
}

private fun slopeOf(volts: DoubleArray, amperes: DoubleArray): Double {
    var n = 0.0
    var meanI = 0.0
    var meanV = 0.0
    var squares = 0.0
    var products = 0.0
    for (k in volts.indices) {
        val v = volts[k]
        val a = amperes[k]
        if (!v.isFinite() || !a.isFinite() || v < 1) continue
        n++
        val dI = a - meanI
        meanI += dI / n
        meanV += (v - meanV) / n
        squares += dI * (a - meanI)
        products += dI * (v - meanV)
    }
    return if (squares > 0) -products / squares else MIN_OHMS
}

/** Returns the voltage without a load around each time: the median of each second. */
private fun openVolts(times: DoubleArray, volts: DoubleArray, amperes: DoubleArray, resistance: Double): DoubleArray {
    val open = DoubleArray(times.size)
    var i = 0
    var before = Double.NaN
    while (i < times.size) {
        var end = i
        while (end < times.size && times[end] < times[i] + SECOND) end++
        val unloaded = DoubleArray(end - i) { volts[i + it] + if (amperes[i + it].isNaN()) 0.0 else resistance * amperes[i + it] }
        val median = quantile(unloaded, 0.5)
        // A dip may fill most of a second.
        // While a robot brakes, its motors charge the battery to more than it holds.
        val level = minOf(MAX_VOLTS, if (before.isNaN()) median else max(median, before - SLOWEST_VOLTS))
        for (k in i until end) open[k] = level
        before = level
        i = end
    }
    return open
}

private fun highest(current: Series, time: Double): Double {
    var i = (current.firstAtOrAfter(time - LAG_SECONDS) - 1).coerceAtLeast(0)
    var high = 0.0
    while (i < current.size && current.x[i] <= time + LATEST_SECONDS) high = max(high, current.y[i++])
    return high
}

private fun lowest(amperes: DoubleArray, from: Int, until: Int) = (from until until).minOf { amperes[it] }

private fun readsWithin(current: Series, from: Double, to: Double): Int {
    var reads = 0
    for (i in current.firstAfter(from) until current.size) {
        if (current.x[i] >= to) break
        if (i > 0 && current.y[i] != current.y[i - 1]) reads++
    }
    return reads
}

/** Returns the median time between two changes of [current], in s. */
private fun usualStep(current: Series): Double {
    val changes = current.x.indices.filter { it > 0 && current.y[it] != current.y[it - 1] }.map { current.x[it] }
    return quantile(DoubleArray(maxOf(changes.size - 1, 0)) { changes[it + 1] - changes[it] }, 0.5)
}

/** A sensor that is read more rarely than this, in s, has not seen most dips. */
private const val SLOWEST_STEP = 0.1
private const val LAG_SECONDS = 0.15
private const val LATEST_SECONDS = 0.35
private const val MIN_VOLTS = 0.5
private const val LONGEST_SECONDS = 2.0
private const val MIN_READS = 2

/** With a higher current, a battery that sags more than in proportion explains a dip, too. */
private const val MAX_AMPERES = 100.0
private const val UNMEASURED_AMPERES = 85.0
private const val LOAD_AMPERES = 30.0
private const val REST_AMPERES = 10.0
private const val HIGH_AMPERES = 60.0
private const val MIN_OHMS = 0.010
private const val MAX_OHMS = 0.100
private const val SECOND = 1.0

/** The largest fall of a battery without a load within a second, in V. */
private const val SLOWEST_VOLTS = 0.2

/** The highest voltage of a battery at rest. */
private const val MAX_VOLTS = 13.2
