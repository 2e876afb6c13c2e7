package badlog.core.analysis

/**
 * Reduces a series of any length to its first, last, smallest and largest value in each pixel column. The cost of drawing then depends only
 * on the screen's width (M4: Jugel et al., "M4: A Visualization-Oriented Time Series Data Aggregation", 2014). An isolated spike is always
 * visible. A gap of a column's width or more stays a gap, and so does one between two columns.
 *
 * A min/max pyramid, built on first use, avoids visiting every sample at every zoom. Not thread-safe.
 */
public class Downsampling(private val series: Series) {
    private val pyramid by lazy { MinMaxPyramid(series.y) }

    /**
     * Fills [into] with the samples from x = [from] to x = [to]. The range is divided into columns of equal width; the last one includes
     * its end.
     *
     * @throws IllegalArgumentException if [to] is not above [from], or either of them is not finite.
     */
    public fun fill(from: Double, to: Double, into: PixelColumns) {
        require(to > from && (to - from).isFinite()) { "A range must go forward, but goes from $from to $to." }
        into.clear()
        if (series.isOrdered) fillOrdered(from, to, into) else fillUnordered(from, to, into)
    }

    private fun fillOrdered(from: Double, to: Double, into: PixelColumns) {
        val y = series.y
        // In JavaScript, each read of a lazy property creates an object: three for each column.
        val pyramid = pyramid
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

    // x goes backwards somewhere: every sample is visited, and goes into the column of its own x.
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

    /** Returns the index after the last sample at or before [to]. */
    private fun endOf(to: Double): Int {
        var end = series.firstAtOrAfter(to)
        while (end < series.size && series.x[end] <= to) end++
        return end
    }

    // Searches in growing steps from the column's start. Neighboring columns end close together, so this is faster than a search of the
    // whole array.
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

/**
 * A series reduced to [count] pixel columns, see [Downsampling]. Create it once for a screen, and fill it again for each zoom.
 *
 * @property count the number of pixel columns.
 */
public class PixelColumns(public val count: Int) {
    /** The value of each column's first sample; NaN where that sample is a gap or there is none. */
    public val first: DoubleArray = DoubleArray(count)

    /** The smallest finite value of each column; NaN if it has none. */
    public val min: DoubleArray = DoubleArray(count)

    /** The largest finite value of each column; NaN if it has none. */
    public val max: DoubleArray = DoubleArray(count)

    /** The value of each column's last sample; NaN where that sample is a gap or there is none. */
    public val last: DoubleArray = DoubleArray(count)

    /** The number of samples in each column, gaps included. */
    public val samples: IntArray = IntArray(count)

    /** Returns whether column [column] begins with a gap, so that no line may lead into it. */
    public fun beginsInGap(column: Int): Boolean = samples[column] > 0 && first[column].isNaN()

    /** Returns whether column [column] ends with a gap, so that no line may lead out of it. */
    public fun endsInGap(column: Int): Boolean = samples[column] > 0 && last[column].isNaN()

    internal fun clear() {
        first.fill(Double.NaN)
        min.fill(Double.NaN)
        max.fill(Double.NaN)
        last.fill(Double.NaN)
        samples.fill(0)
    }
}

/**
 * Finds the smallest and the largest finite value of any range of an array. The time hardly depends on the range's length. Each level holds
 * both values for blocks of [BLOCK] entries of the level below. The pyramid takes a sixteenth of the array's memory.
 */
internal class MinMaxPyramid(private val values: DoubleArray) {
    private val mins = ArrayList<DoubleArray>()
    private val maxs = ArrayList<DoubleArray>()

    /** The smallest finite value that the last call of [find] found; NaN if there was none. */
    var min = Double.NaN
        private set

    /** The largest finite value that the last call of [find] found; NaN if there was none. */
    var max = Double.NaN
        private set

    init {
        if (values.size > BLOCK) addLevel(values, values)
        while (mins.isNotEmpty() && mins.last().size > BLOCK) addLevel(mins.last(), maxs.last())
    }

    private fun addLevel(lowest: DoubleArray, highest: DoubleArray) {
        val blocks = (lowest.size + BLOCK - 1) / BLOCK
        val levelMins = DoubleArray(blocks)
        val levelMaxs = DoubleArray(blocks)
        for (block in 0 until blocks) {
            clear()
            scan(lowest, highest, block * BLOCK, minOf((block + 1) * BLOCK, lowest.size))
            levelMins[block] = min
            levelMaxs[block] = max
        }
        mins += levelMins
        maxs += levelMaxs
    }

    /** Finds [min] and [max] of the values from index [from] until [until]. */
    fun find(from: Int, until: Int) {
        clear()
        var start = from
        var end = until
        var lowest = values
        var highest = values
        for (level in mins.indices) {
            if (end - start < 2 * BLOCK) break
            val firstWhole = (start + BLOCK - 1) / BLOCK
            val endWhole = end / BLOCK
            scan(lowest, highest, start, firstWhole * BLOCK)
            scan(lowest, highest, endWhole * BLOCK, end)
            start = firstWhole
            end = endWhole
            lowest = mins[level]
            highest = maxs[level]
        }
        scan(lowest, highest, start, end)
    }

    private fun clear() {
        min = Double.NaN
        max = Double.NaN
    }

    private fun scan(lowest: DoubleArray, highest: DoubleArray, from: Int, until: Int) {
        var least = if (min.isNaN()) Double.POSITIVE_INFINITY else min
        var most = if (max.isNaN()) Double.NEGATIVE_INFINITY else max
        for (i in from until until) {
            val low = lowest[i]
            val high = highest[i]
            if (low < least && low > Double.NEGATIVE_INFINITY) least = low
            if (high > most && high < Double.POSITIVE_INFINITY) most = high
        }
        if (least <= most) {
            min = least
            max = most
        }
    }
}

private const val BLOCK = 32
