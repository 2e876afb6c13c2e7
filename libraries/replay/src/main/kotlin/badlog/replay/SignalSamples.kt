package badlog.replay

import badlog.analysis.Series

/** These samples in the order of x; those of one x keep their order. */
internal fun Series.ordered(): Series {
    if (isOrdered) return this
    val order = (0 until size).sortedBy { x[it] }
    return Series(DoubleArray(size) { x[order[it]] }, DoubleArray(size) { y[order[it]] })
}

/** These samples with at most the first of each gap's, and not even that when [keepsFirst] is false or nothing was before. */
internal fun Series.withoutGaps(keepsFirst: Boolean): Series {
    fun isKept(i: Int) = !y[i].isNaN() || (keepsFirst && i > 0 && !y[i - 1].isNaN())
    val kept = (0 until size).count(::isKept)
    if (kept == size) return this
    val keptX = DoubleArray(kept)
    val keptY = DoubleArray(kept)
    var at = 0
    for (i in 0 until size) {
        if (!isKept(i)) continue
        keptX[at] = x[i]
        keptY[at++] = y[i]
    }
    return Series(keptX, keptY)
}
