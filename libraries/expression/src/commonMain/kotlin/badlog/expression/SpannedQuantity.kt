package badlog.expression

import badlog.core.analysis.Span
import badlog.expression.samples.Column

/**
 * A [quantity] with the [samples] over time in which it was found. It can be determined again for parts of them.
 *
 * @param smallest whether the smallest sample is the most significant, rather than the largest; null if the first is.
 */
internal class SpannedQuantity(private val quantity: Quantity, private val samples: Column, private val smallest: Boolean?) {
    /**
     * Returns the most significant value in each of [spans]. A result is null for a span without a sample. All results are null if spans
     * overlap or are not in the order of time.
     */
    fun over(spans: List<Span>): List<Quantity?> {
        val best = IntArray(spans.size) { NONE }
        if (spans.zipWithNext().all { (one, next) -> one.to <= next.from }) {
            for (sample in 0 until samples.size) {
                val value = samples.y[sample]
                if (value.isNaN()) continue
                val place = placeOf(samples.time(sample), spans)
                if (place != NONE && (best[place] == NONE || isFarther(value, samples.y[best[place]]))) best[place] = sample
            }
        }
        return best.map { if (it == NONE) null else quantity.copy(value = samples.y[it], time = samples.time(it)) }
    }

    private fun isFarther(value: Double, other: Double) = when (smallest) {
        true -> value < other
        false -> value > other
        null -> false
    }

    private fun placeOf(time: Double, spans: List<Span>): Int {
        val place = spans.binarySearch {
            if (time < it.from) {
                1
            } else if (time > it.to) {
                -1
            } else {
                0
            }
        }
        return if (place < 0) NONE else place
    }
}

private const val NONE = -1
