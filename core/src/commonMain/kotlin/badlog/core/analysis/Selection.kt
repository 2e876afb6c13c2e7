package badlog.core.analysis

import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * Partially sorts [values] from index [from] until [until], so that [place] has the same number as after sorting. No larger number is
 * before it, and no smaller one after it. None of the values may be NaN.
 *
 * Selection by Floyd and Rivest ("Algorithm 489", 1975): the pivot comes from a sample around the place, so that a few
 * rounds nearly always suffice. If they do not, the rest is sorted.
 */
public fun select(values: DoubleArray, place: Int, from: Int = 0, until: Int = values.size) {
    var low = from
    var high = until - 1
    var rounds = MAX_ROUNDS
    while (high > low) {
        if (high - low < MAX_SORTED || rounds-- == 0) {
            values.sort(low, high + 1)
            return
        }
        if (high - low > MIN_SAMPLED) selectInSample(values, place, low, high)
        val pivot = values[place]
        var left = low
        var right = high
        while (left <= right) {
            while (values[left] < pivot) left++
            while (values[right] > pivot) right--
            if (left <= right) {
                val value = values[left]
                values[left++] = values[right]
                values[right--] = value
            }
        }
        // The values between the two equal the pivot.
        if (place >= left) {
            low = left
        } else if (place <= right) {
            high = right
        } else {
            return
        }
    }
}

/** Moves a pivot to [place]: a value slightly farther from the middle than the wanted one, selected within a sample. */
private fun selectInSample(values: DoubleArray, place: Int, low: Int, high: Int) {
    val size = high - low + 1.0
    val rank = place - low + 1.0
    val sampleSize = exp(ln(size) * 2 / 3) / 2
    val deviation = sqrt(ln(size) * sampleSize * (size - sampleSize) / size) / 2
    val shift = if (rank < size / 2) -deviation else deviation
    val sampleLow = maxOf(low, (place - rank * sampleSize / size + shift).toInt())
    val sampleHigh = minOf(high, (place + (size - rank) * sampleSize / size + shift).toInt())
    select(values, place, sampleLow, sampleHigh + 1)
}

// Up to this many values are simply sorted.
private const val MAX_SORTED = 32

// From this many values on, taking a sample is worth it.
private const val MIN_SAMPLED = 600
private const val MAX_ROUNDS = 8

/**
 * Returns the value below which [share] of the total weight lies. Only the first [count] of [values] are used. The result is the smallest
 * value that has, together with all values below it, at least that share of the weight; if exactly that share, it is the midpoint between
 * that value and the next. The weights of equal values may be given together or separately, with the same result. NaN if there are no
 * values.
 *
 * @param values not NaN.
 * @param weights above 0.
 * @param share from 0 to 1.
 */
public fun weightedPercentile(values: DoubleArray, weights: DoubleArray, count: Int, share: Double): Double =
    WeightedPercentiles(values, weights, count).of(share)

/**
 * Several percentiles of the same values, each defined as in [weightedPercentile]. The range of the values is divided into equal parts;
 * the weights of the parts show which part contains a percentile, so it is selected from a few values only.
 */
internal class WeightedPercentiles(private val values: DoubleArray, private val weights: DoubleArray, private val count: Int) {
    private var smallest = Double.POSITIVE_INFINITY
    private val scale: Double
    private val parts = DoubleArray(if (count < MAX_UNDIVIDED) 1 else PARTS)
    private val sizes = IntArray(parts.size)
    private val total: Double

    init {
        var largest = Double.NEGATIVE_INFINITY
        for (i in 0 until count) {
            val value = values[i]
            if (value < smallest) smallest = value
            if (value > largest) largest = value
        }
        // If all values are equal, or their range is too large for a number, all are in the first part.
        scale = ((parts.size - 1) / (largest - smallest)).takeIf { it.isFinite() && largest - smallest < Double.POSITIVE_INFINITY } ?: 0.0
        for (i in 0 until count) {
            val part = partOf(values[i])
            parts[part] += weights[i]
            sizes[part]++
        }
        total = parts.sum()
    }

    /** Returns the percentile at [share], a fraction from 0 to 1; NaN if there are no values. */
    fun of(share: Double): Double {
        if (count == 0) return Double.NaN
        val rounding = total * ROUNDING
        val wanted = total * share - rounding
        var part = 0
        var below = 0.0
        while (part < parts.size - 1 && below + parts[part] < wanted) below += parts[part++]
        val someValues = DoubleArray(sizes[part])
        val someWeights = DoubleArray(sizes[part])
        var size = 0
        for (i in 0 until count) {
            if (partOf(values[i]) != part) continue
            someValues[size] = values[i]
            someWeights[size++] = weights[i]
        }
        return selected(someValues, someWeights, below, wanted, rounding)
    }

    private fun partOf(value: Double): Int = ((value - smallest) * scale).toInt()

    /** Returns the value of [some] at which the weight reaches [wanted]; the values below all of them weigh [before]. */
    private fun selected(some: DoubleArray, weightsOfSome: DoubleArray, before: Double, wanted: Double, rounding: Double): Double {
        var low = 0
        var high = some.size - 1
        var below = before
        var random = 1
        while (true) {
            // Any place is correct, but with a fixed one, some orders of values would be slow.
            random = random * 1_103_515_245 + 12_345
            val pivot = some[low + (random ushr 1) % (high - low + 1)]
            var less = low
            var more = high
            var weightBelow = below
            var weightAt = 0.0
            var i = low
            while (i <= more) {
                val value = some[i]
                if (value < pivot) {
                    weightBelow += weightsOfSome[i]
                    swap(some, weightsOfSome, i++, less++)
                } else if (value > pivot) {
                    swap(some, weightsOfSome, i, more--)
                } else {
                    weightAt += weightsOfSome[i++]
                }
            }
            if (less > low && weightBelow >= wanted) {
                high = less - 1
            } else if (weightBelow + weightAt >= wanted || more == high) {
                val isExact = weightBelow + weightAt <= wanted + 2 * rounding
                return if (isExact) (pivot + nextAbove(pivot)) / 2 else pivot
            } else {
                below = weightBelow + weightAt
                low = more + 1
            }
        }
    }

    private fun nextAbove(value: Double): Double {
        var next = Double.POSITIVE_INFINITY
        for (i in 0 until count) if (values[i] > value && values[i] < next) next = values[i]
        return if (next.isFinite()) next else value
    }
}

private fun swap(values: DoubleArray, weights: DoubleArray, one: Int, other: Int) {
    val value = values[one]
    values[one] = values[other]
    values[other] = value
    val weight = weights[one]
    weights[one] = weights[other]
    weights[other] = weight
}

private const val PARTS = 1024

/** From this many values on, their range is divided into parts. */
private const val MAX_UNDIVIDED = 64

/** The upper limit of the relative difference between sums of the same weights in different orders. */
private const val ROUNDING = 1e-9
