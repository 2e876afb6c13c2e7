package badlog.viewer.catalog

import badlog.core.analysis.Series
import kotlin.math.ceil
import kotlin.math.floor

/**
 * The shape of a series in [COLUMNS] columns of equal width in x, each with its extremes.
 *
 * @property bytes two bytes for each column, its smallest and its largest value, scaled from 0 for the series' minimum to 255 for its
 *   maximum. The smallest is above the largest if the column has no value.
 */
class PreviewLine(val bytes: ByteArray) {
    init {
        require(bytes.size == BYTES) { "A preview has $BYTES bytes, not ${bytes.size}." }
    }

    /** Returns whether [column] has a value. */
    fun has(column: Int): Boolean = low(column) <= high(column)

    /** Returns the smallest value of [column], from 0 for the minimum to 1 for the maximum. */
    fun low(column: Int): Float = bytes[2 * column].toUByte().toInt() / 255f

    /** Returns the largest value of [column], from 0 for the minimum to 1 for the maximum. */
    fun high(column: Int): Float = bytes[2 * column + 1].toUByte().toInt() / 255f

    override fun equals(other: Any?): Boolean = other is PreviewLine && bytes.contentEquals(other.bytes)

    override fun hashCode(): Int = bytes.contentHashCode()

    companion object {
        const val COLUMNS = 48

        /** A preview without values in any column. */
        val NONE: PreviewLine by lazy { PreviewLine(ByteArray(BYTES) { if (it % 2 == 0) 1 else 0 }) }

        const val BYTES = 2 * COLUMNS

        /**
         * Returns the shape of [series]. Its finite values are between [min] and [max]; both are NaN if it has none.
         *
         * @param held the whole range of x, if each value holds until the next one; otherwise null.
         */
        fun of(series: Series, min: Double, max: Double, held: ClosedFloatingPointRange<Double>? = null): PreviewLine {
            val bytes = ByteArray(BYTES) { if (it % 2 == 0) -1 else 0 }
            val x = series.x
            val y = series.y
            if (x.isEmpty() || min.isNaN()) return PreviewLine(bytes)
            // Without ordered x, the order of the rows is more useful.
            val isOrdered = series.isOrdered
            val from = held?.start ?: if (isOrdered) x.first() else 0.0
            val width = if (isOrdered) (held?.endInclusive ?: x.last()) - from else x.size - 1.0
            val perX = if (width > 0) COLUMNS / width else 0.0
            val perY = if (max > min) 255 / (max - min) else 0.0
            fun columnOf(i: Int) = (((if (isOrdered) x[i] else i.toDouble()) - from) * perX).toInt().coerceIn(0, COLUMNS - 1)
            for (i in x.indices) {
                val value = y[i]
                if (!value.isFinite()) continue
                val share = (value - min) * perY
                val low = floor(share).toInt().coerceIn(0, 255)
                val high = ceil(share).toInt().coerceIn(0, 255)
                val first = columnOf(i)
                val last = if (held == null) {
                    first
                } else if (i + 1 < x.size) {
                    columnOf(i + 1)
                } else {
                    COLUMNS - 1
                }
                for (column in first..last) {
                    if (low < bytes[2 * column].toUByte().toInt()) bytes[2 * column] = low.toByte()
                    if (high > bytes[2 * column + 1].toUByte().toInt()) bytes[2 * column + 1] = high.toByte()
                }
            }
            return PreviewLine(bytes)
        }
    }
}
