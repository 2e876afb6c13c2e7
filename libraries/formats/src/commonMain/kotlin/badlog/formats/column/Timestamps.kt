package badlog.formats.column

import badlog.core.analysis.stableOrder
import badlog.core.text.originOf
import kotlin.math.round

/** The growing list of times of one or several columns, in s. */
internal class Timestamps(private val keepsSamples: Boolean) {
    private val growing = GrowingDoubles()
    private var isOrdered = true
    private var last = Double.NEGATIVE_INFINITY

    var size = 0
        private set

    /** The number of times that follow a later one; valid after [finish]. */
    var disorder = 0
        private set

    /** The times, ascending; valid after [finish]. */
    var times = DoubleArray(0)
        private set

    /** For each of [times], the index of its sample, or null if they were already in order; valid after [finish]. */
    var order: IntArray? = null
        private set
    private var isFinished = false

    fun add(time: Double) {
        if (time < last) isOrdered = false
        last = time
        if (keepsSamples) growing.add(time)
        size++
    }

    /** Returns a copy with the same times so far, which then grows independently. */
    fun copy(): Timestamps {
        val copy = Timestamps(keepsSamples)
        copy.growing.addAll(growing)
        copy.isOrdered = isOrdered
        copy.last = last
        copy.size = size
        return copy
    }

    /**
     * Completes the list. Drops times outside [span], and sorts the others; times before 0 are moved to the start of [span]. If that start
     * is a time since 1970, all times are then counted from it. May be called again.
     */
    fun finish(span: ClosedFloatingPointRange<Double>) {
        if (isFinished || !keepsSamples) return
        isFinished = true
        order(growing.take(), span)
        // Beside a number as large as that, a fraction has rounding errors; whole µs have none.
        val origin = originOf(round(span.start * MICROS))
        if (origin > 0) for (i in times.indices) times[i] = round(times[i] * MICROS - origin) / MICROS
    }

    private fun order(all: DoubleArray, span: ClosedFloatingPointRange<Double>) {
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

internal const val MICROS = 1e6
