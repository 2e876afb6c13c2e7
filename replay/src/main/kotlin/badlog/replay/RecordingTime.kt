package badlog.replay

import badlog.analysis.XAxis

/** A recording without a time is played as if its robot had logged every 20 ms, which is what robots do. */
private const val ROWS_PER_SECOND = 50.0

/** How far [axis] goes in a second. An x that is neither time nor index is taken for seconds. */
internal fun unitsPerSecond(axis: XAxis): Double = when (axis.unit) {
    "s", "sec" -> 1.0
    "ms" -> 1e3
    "us", "\u00b5s", "\u03bcs" -> 1e6
    "ns" -> 1e9
    "min" -> 1.0 / 60
    "h" -> 1.0 / 3600
    else -> if (axis.topic == null) ROWS_PER_SECOND else 1.0
}
