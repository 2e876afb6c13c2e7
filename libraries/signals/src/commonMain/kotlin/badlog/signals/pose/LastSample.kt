package badlog.signals.pose

import badlog.core.analysis.Series

/**
 * Returns the index of the last sample at or before [position]; -1 if there is none. If x goes backwards, it is the last one in the order of the
 * file.
 */
fun Series.lastAtOrBefore(position: Double): Int {
    if (isOrdered) return firstAfter(position) - 1
    var index = size - 1
    while (index >= 0 && !(x[index] <= position)) index--
    return index
}
