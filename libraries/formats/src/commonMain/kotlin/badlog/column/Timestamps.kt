package badlog.column

import badlog.analysis.stableOrder

/** The growing times of one or several columns, in s. */
internal class Timestamps(private val keepsSamples: Boolean) {
    private val growing = GrowingDoubles()
    private var isOrdered = true
    private var last = Double.NEGATIVE_INFINITY

    /** How many times there are. */
    var size = 0
        private set

    /** How many times stand behind a later one; after [finish]. */
    var disorder = 0
        private set

    /** The times, ascending; after [finish]. */
    var times = DoubleArray(0)
        private set

    /** For each of [times] the sample that it belongs to, or null when they stand in their order; after [finish]. */
    var order: IntArray? = null
        private set
    private var isFinished = false

    fun add(time: Double) {
        if (time < last) isOrdered = false
        last = time
        if (keepsSamples) growing.add(time)
        size++
    }

    /** Timestamps that have had the same times so far, and go their own way from now on. */
    fun copy(): Timestamps {
        val copy = Timestamps(keepsSamples)
        copy.growing.addAll(growing)
        copy.isOrdered = isOrdered
        copy.last = last
        copy.size = size
        return copy
    }

    /**
     * Says that no more times come. Drops what does not lie in [span], and sorts the others; what was before 0 is put where
     * [span] begins. May be called again.
     */
    fun finish(span: ClosedFloatingPointRange<Double>) {
        if (isFinished || !keepsSamples) return
        isFinished = true
        val all = growing.take()
        val kept = all.count { it < 0 || it in span }
        if (isOrdered && kept == size) {
            for (i in all.indices) if (all[i] < 0) all[i] = span.start else break
            times = all
            return
        }
        val indices = IntArray(kept)
        var next = 0
        for (i in 0 until size) if (all[i] < 0 || all[i] in span) indices[next++] = i
        for (i in 1 until kept) if (all[indices[i]] < all[indices[i - 1]]) disorder++
        val sorted = if (disorder == 0) indices else stableOrder(all, indices)
        order = sorted
        times = DoubleArray(kept) { i -> all[sorted[i]].let { if (it < 0) span.start else it } }
    }
}
