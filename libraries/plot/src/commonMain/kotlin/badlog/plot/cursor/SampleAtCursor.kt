package badlog.plot.cursor

import badlog.analysis.GraphSeries
import badlog.rules.path.lastAtOrBefore

/**
 * Which sample of this line a cursor at [x] reads; -1 for none, and for an x that is NaN.
 *
 * One rule for all front ends: what lasts until it changes is read from the last sample at or before the cursor, as a state or
 * the value of a topic with times of its own; there is nothing to read before its first sample. Numbers that were measured row by
 * row, and what is calculated from others, are read from the nearest sample, on which the cursor's dot stands.
 */
public fun GraphSeries.indexAt(x: Double): Int = when {
    x.isNaN() -> -1
    states != null || holds -> data.lastAtOrBefore(x)
    else -> data.nearest(x)
}

/** Where on x the dot of a cursor at [x] stands on this line: at the cursor where the value lasts, else at its sample; NaN for nowhere. */
public fun GraphSeries.dotAt(x: Double): Double {
    val index = indexAt(x)
    return if (index < 0) {
        Double.NaN
    } else if (holds) {
        x
    } else {
        data.x[index]
    }
}

/**
 * What sample [index] of this line says: the name of its state, or what [numberText] makes of its number; `–` for a gap, and where
 * there is no such sample.
 */
public fun GraphSeries.textOf(index: Int, numberText: (Double) -> String): String {
    if (index !in 0 until data.size) return NOTHING
    val value = data.y[index]
    if (value.isNaN()) return NOTHING
    return states?.let { it.getOrElse(value.toInt()) { "?" } } ?: numberText(value)
}

private const val NOTHING = "–"
