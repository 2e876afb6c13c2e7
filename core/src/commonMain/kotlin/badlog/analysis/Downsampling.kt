package badlog.analysis

/**
 * Draws a series of any length at the cost of the screen's width: the smallest and largest value of each pixel column, with
 * its first and last (M4: Jugel et al., "M4: A Visualization-Oriented Time Series Data Aggregation", 2014). A lone spike
 * always shows, a gap of a column's width or more stays a gap, and so does one between two columns.
 *
 * A min/max pyramid, built at the first use, spares looking at every sample at every zoom. Not safe for use by several
 * threads.
 */
public class Downsampling(private val series: Series) {
    private val pyramid by lazy { MinMaxPyramid(series.y) }

    /**
     * Fills [into] with what lies from x = [from] to x = [to]; the range is divided into columns of equal width, of which
     * the last includes its end.
     *
     * @throws IllegalArgumentException when [to] is not above [from] or one of them is not finite.
     */
    public fun fill(from: Double, to: Double, into: PixelColumns) {
        require(to > from && (to - from).isFinite()) { "A range must go forward, but goes from $from to $to." }
        into.clear()
        if (series.isOrdered) fillOrdered(from, to, into) else fillUnordered(from, to, into)
    }

    private fun fillOrdered(from: Double, to: Double, into: PixelColumns) {
        val y = series.y
        val end = endOf(to)
        var start = series.firstAtOrAfter(from)
        for (column in 0 until into.count) {
            val isLast = column == into.count - 1
            val next = if (isLast) end else firstAtOrAfter(from + (to - from) * (column + 1) / into.count, start, end)
            if (next > start) {
                into.samples[column] = next - start
                into.first[column] = finiteOrGap(y[start])
                into.last[column] = finiteOrGap(y[next - 1])
                pyramid.find(start, next)
                into.min[column] = pyramid.min
                into.max[column] = pyramid.max
            }
            start = next
        }
    }

    // x goes backwards somewhere: every sample is looked at, and each falls into the column where it stands.
    private fun fillUnordered(from: Double, to: Double, into: PixelColumns) {
        val x = series.x
        val y = series.y
        for (i in x.indices) {
            if (x[i] !in from..to) continue
            val column = minOf(((x[i] - from) / (to - from) * into.count).toInt(), into.count - 1)
            val value = finiteOrGap(y[i])
            if (into.samples[column]++ == 0) into.first[column] = value
            into.last[column] = value
            if (value.isNaN()) continue
            if (!(into.min[column] <= value)) into.min[column] = value
            if (!(into.max[column] >= value)) into.max[column] = value
        }
    }

    private fun finiteOrGap(value: Double) = if (value.isFinite()) value else Double.NaN

    /** One past the last sample at or before [to]. */
    private fun endOf(to: Double): Int {
        var end = series.firstAtOrAfter(to)
        while (end < series.size && series.x[end] <= to) end++
        return end
    }

    // Gallops from the column's start: neighbouring columns end near each other, so this beats a search of everything.
    private fun firstAtOrAfter(position: Double, from: Int, until: Int): Int {
        val x = series.x
        var low = from
        var step = 1
        while (low + step < until && x[low + step] < position) {
            low += step
            step *= 2
        }
        var high = minOf(low + step, until)
        while (low < high) {
            val middle = (low + high) ushr 1
            if (x[middle] < position) low = middle + 1 else high = middle
        }
        return low
    }
}
