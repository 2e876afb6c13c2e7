package badlog.replay

import badlog.analysis.Units
import badlog.analysis.XAxis

/** A recording without a time is played as if its robot had logged every 20 ms, which is what robots do. */
private const val ROWS_PER_SECOND = 50.0

/** How far [axis] goes in a second. An x that is neither time nor index is taken for seconds. */
internal fun unitsPerSecond(axis: XAxis): Double = Units.secondsIn(axis.unit)?.let { 1 / it } ?: if (axis.isIndex) ROWS_PER_SECOND else 1.0
