package badlog.core.analysis

import kotlin.math.abs

/**
 * Samples over x: `(x[i], y[i])` for every `i`. Several series may share one array of x.
 *
 * @property x the position of each sample; finite. Usually ascending, see [isOrdered]. Do not change this array.
 * @property y the samples, of the same size as [x]; NaN is a gap, and an infinity is drawn as one. Do not change this array.
 * @throws IllegalArgumentException if the sizes differ.
 */
public class Series(public val x: DoubleArray, public val y: DoubleArray) {
    init {
        require(x.size == y.size) { "A series needs one x for each y, but has ${x.size} for ${y.size}." }
    }

    /** The number of samples, gaps included. */
    public val size: Int get() = x.size

    /** Whether x never goes backwards, so that it can be searched by bisection. */
    public val isOrdered: Boolean by lazy {
        var ordered = true
        for (i in 1 until x.size) if (x[i] < x[i - 1]) ordered = false
        ordered
    }

    /** The smallest and the largest x, or null if there are no samples. */
    public val range: ClosedFloatingPointRange<Double>? by lazy {
        when {
            x.isEmpty() -> null
            isOrdered -> x.first()..x.last()
            else -> x.min()..x.max()
        }
    }

    /** Returns the index of the first sample at or after [position]; [size] if there is none. The series must be ordered. */
    public fun firstAtOrAfter(position: Double): Int {
        var low = 0
        var high = size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (x[middle] < position) low = middle + 1 else high = middle
        }
        return low
    }

    /** Returns the index of the first sample after [position]; [size] if there is none. The series must be ordered. */
    public fun firstAfter(position: Double): Int {
        var low = 0
        var high = size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (x[middle] <= position) low = middle + 1 else high = middle
        }
        return low
    }

    /**
     * Returns the index of the sample nearest to [position], or the earlier of two that are equally near. Returns -1 if there are no
     * samples.
     */
    public fun nearest(position: Double): Int {
        if (size == 0) return -1
        if (!isOrdered) return nearestUnordered(position)
        val after = firstAtOrAfter(position)
        return when {
            after == 0 -> 0
            after == size -> size - 1
            x[after] - position < position - x[after - 1] -> after
            else -> after - 1
        }
    }

    private fun nearestUnordered(position: Double): Int {
        var nearest = 0
        for (i in 1 until size) if (abs(x[i] - position) < abs(x[nearest] - position)) nearest = i
        return nearest
    }
}
