package badlog.signals.pose

import badlog.core.analysis.Series

/**
 * Returns the index of the last sample at or before [position], the last in the order of the file if x goes backwards; -1 if there is none.
 */
fun Series.lastAtOrBefore(position: Double): Int {
    if (isOrdered) return firstAfter(position) - 1
    var index = size - 1
    while (index >= 0 && !(x[index] <= position)) index--
    return index
}
