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
