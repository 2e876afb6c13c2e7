package badlog.analysis

import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * Puts the number that sorting would bring to index [place] there, those that are not larger before it and those that
 * are not smaller behind it, all of [values] from index [from] until [until]. None of them may be NaN.
 *
 * Selection by Floyd and Rivest ("Algorithm 489", 1975): the pivot comes from a sample around the place, so that few rounds
 * do nearly always. Where the values are such that they do not, it sorts what is left.
 */
public fun select(values: DoubleArray, place: Int, from: Int = 0, until: Int = values.size) {
    var low = from
    var high = until - 1
    var rounds = MAX_ROUNDS
    while (high > low) {
        if (high - low < FEW || rounds-- == 0) {
            values.sort(low, high + 1)
            return
        }
        if (high - low > MANY) selectInSample(values, place, low, high)
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
        // What stands between the two, if anything, is the pivot.
        if (place >= left) {
            low = left
        } else if (place <= right) {
            high = right
        } else {
            return
        }
    }
}

/** Brings to [place] a value that is a little beyond the wanted one, seen from the middle, by selecting in a sample. */
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

// Few enough to sort.
private const val FEW = 32

// A sample pays from here on.
private const val MANY = 600
private const val MAX_ROUNDS = 8

/**
 * The value below which the [share] of all weight lies: the smallest of the first [count] of [values] at which the weights of it and
 * of those below it come to so much, and where they come to just that, the middle between it and the next. Values that are
 * equal may have their weights together or apart, which changes nothing. NaN without values.
 *
 * @param values not NaN; they and their weights change their places.
 * @param weights above 0.
 * @param share from 0 to 1.
 */
public fun weightedPercentile(values: DoubleArray, weights: DoubleArray, count: Int, share: Double): Double {
    if (count == 0) return Double.NaN
    var total = 0.0
    for (i in 0 until count) total += weights[i]
    val rounding = total * ROUNDING
    val wanted = total * share - rounding
    var low = 0
    var high = count - 1
    var below = 0.0
    var random = 1
    while (true) {
        // Any place will do; from a fixed one the order of the values could make this slow.
        random = random * 1_103_515_245 + 12_345
        val pivot = values[low + (random ushr 1) % (high - low + 1)]
        var less = low
        var more = high
        var weightBelow = below
        var weightAt = 0.0
        var i = low
        while (i <= more) {
            val value = values[i]
            if (value < pivot) {
                weightBelow += weights[i]
                exchange(values, weights, i++, less++)
            } else if (value > pivot) {
                exchange(values, weights, i, more--)
            } else {
                weightAt += weights[i++]
            }
        }
        if (less > low && weightBelow >= wanted) {
            high = less - 1
        } else if (weightBelow + weightAt >= wanted || more == high) {
            val isJustReached = weightBelow + weightAt <= wanted + 2 * rounding
            return if (isJustReached) (pivot + nextAbove(values, count, pivot)) / 2 else pivot
        } else {
            below = weightBelow + weightAt
            low = more + 1
        }
    }
}

private fun exchange(values: DoubleArray, weights: DoubleArray, one: Int, other: Int) {
    val value = values[one]
    values[one] = values[other]
    values[other] = value
    val weight = weights[one]
    weights[one] = weights[other]
    weights[other] = weight
}

private fun nextAbove(values: DoubleArray, count: Int, value: Double): Double {
    var next = Double.POSITIVE_INFINITY
    for (i in 0 until count) if (values[i] > value && values[i] < next) next = values[i]
    return if (next.isFinite()) next else value
}

// Sums of the same weights in another order differ by less.
private const val ROUNDING = 1e-9
