package badlog.wpilog

/** The growing times of one or several columns, in s. */
internal class Clock(private val keepsSamples: Boolean) {
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

    /** A clock that has had the same times so far, and goes its own way from now on. */
    fun copy(): Clock {
        val copy = Clock(keepsSamples)
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
        val sorted = if (disorder == 0) indices else sortedStably(indices, all)
        order = sorted
        times = DoubleArray(kept) { i -> all[sorted[i]].let { if (it < 0) span.start else it } }
    }
}

/** [indices] in the order of their [keys], equal ones as they stand: a merge sort from the bottom up, without objects. */
private fun sortedStably(indices: IntArray, keys: DoubleArray): IntArray {
    var from = indices
    var to = IntArray(indices.size)
    var width = 1
    while (width < from.size) {
        var start = 0
        while (start < from.size) {
            merge(from, to, keys, start, minOf(start.toLong() + width, from.size.toLong()).toInt(), width)
            start = minOf(start.toLong() + 2L * width, from.size.toLong()).toInt()
        }
        val sorted = to
        to = from
        from = sorted
        width = minOf(width * 2L, from.size.toLong()).toInt()
    }
    return from
}

private fun merge(from: IntArray, to: IntArray, keys: DoubleArray, start: Int, middle: Int, width: Int) {
    val end = minOf(middle.toLong() + width, from.size.toLong()).toInt()
    var left = start
    var right = middle
    for (i in start until end) {
        val takesLeft = right == end || (left < middle && keys[from[left]] <= keys[from[right]])
        to[i] = if (takesLeft) from[left++] else from[right++]
    }
}
