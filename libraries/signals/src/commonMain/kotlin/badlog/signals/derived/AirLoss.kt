package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.max

/**
 * Returns the steady loss of stored air, in psi/s: the slope of [pressure] over the last [LOSS_SECONDS]. NaN unless [compressor] was off
 * throughout, where samples are rare, and after sudden drops, because a cylinder takes its air at once.
 */
fun airLoss(pressure: Series, compressor: Series): Series {
    val runs = compressor.heldAt(pressure.x)
    var since = 0
    return Series(
        pressure.x,
        DoubleArray(pressure.size) { i ->
            // A log of changes has no sample just before.
            val used = i > 0 && maxOf(fallWithin(pressure, i, USE_SECONDS), pressure.y[i - 1] - pressure.y[i]) > USE_PSI
            if (used || runs[i] != 0.0) since = i + 1
            val first = if (since < i) indexBefore(pressure.x, i, LOSS_SECONDS, since) else i
            // The means below would spread a cylinder's drop over the parts beside it.
            val isRare = i - first < PARTS * AVERAGED
            if (isRare || pressure.x[i] - pressure.x[first] < LOSS_SECONDS * 0.9) {
                Double.NaN
            } else {
                // A leak lasts; cylinders take air for moments only, however often, and small ones hardly more than the error of a sensor.
                val ends = IntArray(PARTS + 1) { part -> indexBefore(pressure.x, i, LOSS_SECONDS * (PARTS - part) / PARTS, first) }
                DoubleArray(PARTS) { part -> lossOver(pressure, ends[part], ends[part + 1]) }.apply { sort() }[TWO_THIRDS_FALL]
            }
        },
    )
}

/** Returns the largest rise of [pressure] within a second in the last [RUN_SECONDS], in psi. NaN unless [compressor] was on throughout. */
fun airGain(pressure: Series, compressor: Series): Series {
    val runs = compressor.heldAt(pressure.x)
    var since = 0
    val rises = DoubleArray(pressure.size) { i ->
        val first = indexBefore(pressure.x, i, 1.0)
        ends(pressure, i - 2, i) - ends(pressure, first, first + 2)
    }
    return Series(
        pressure.x,
        DoubleArray(pressure.size) { i ->
            if (runs[i] != 1.0) since = i + 1
            if (since >= i || pressure.x[i] - pressure.x[since] < RUN_SECONDS) {
                Double.NaN
            } else {
                var most = 0.0
                for (k in indexBefore(pressure.x, i, RUN_SECONDS - 1, since)..i) most = max(most, rises[k])
                most
            }
        },
    )
}

private fun lossOver(pressure: Series, from: Int, to: Int): Double {
    val seconds = pressure.x[to] - pressure.x[from]
    val fall = ends(pressure, from - AVERAGED / 2, from + AVERAGED / 2) - ends(pressure, to - AVERAGED / 2, to + AVERAGED / 2)
    return if (seconds > 0) fall / seconds else 0.0
}

private fun fallWithin(pressure: Series, at: Int, seconds: Double) = pressure.y[indexBefore(pressure.x, at, seconds)] - pressure.y[at]

private fun ends(pressure: Series, from: Int, to: Int): Double {
    val first = from.coerceIn(0, pressure.size - 1)
    val last = to.coerceIn(0, pressure.size - 1)
    return (first..last).sumOf { pressure.y[it] } / (last - first + 1)
}

private const val LOSS_SECONDS = 4.0
private const val PARTS = 16

/** The sixth lowest: the pressure falls in two thirds of the parts. */
private const val TWO_THIRDS_FALL = 5
private const val RUN_SECONDS = 8.0
private const val USE_SECONDS = 0.15
private const val USE_PSI = 2.5
private const val AVERAGED = 4
