package badlog.viewer.draw.curve

import badlog.core.analysis.Downsampling
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series

/**
 * The points of one line on the screen. They are the samples themselves if they are few, otherwise a handful for each pixel column. Point
 * `i` is `(x[i], y[i])`; a NaN in [y] breaks the line.
 *
 * @param holdsUntil null to join samples by straight lines. Otherwise each value holds until the next sample, in steps, and the last one
 *   until this x, as for a topic that is logged when it changes. Only for an ordered series.
 */
class Curve(private val series: Series, private val holdsUntil: Double? = null) {
    private val downsampling = Downsampling(series)

    /** The x of each point, in the first [size] entries. */
    var x: DoubleArray = DoubleArray(0)
        private set

    /** The value of each point, in the first [size] entries; NaN where the line is broken. */
    var y: DoubleArray = DoubleArray(0)
        private set

    private var isCorner = BooleanArray(0)

    var size: Int = 0
        private set

    /** The smallest finite visible value; NaN if there is none. */
    var min: Double = Double.NaN
        private set

    /** The largest finite visible value; NaN if there is none. */
    var max: Double = Double.NaN
        private set

    /** Whether the samples are so far apart that each has a dot. */
    var isSparse: Boolean = false
        private set

    /** Whether there are more samples than pixel columns. */
    var isDense: Boolean = false
        private set

    /** Finds the points for the range from [from] to [to], on a screen with the pixel columns of [columns]. */
    fun draw(from: Double, to: Double, columns: PixelColumns) {
        size = 0
        min = Double.NaN
        max = Double.NaN
        isSparse = false
        isDense = true
        if (!series.isOrdered) {
            drawUnordered(from, to, columns)
            return
        }
        val first = series.firstAtOrAfter(from)
        var end = series.firstAtOrAfter(to)
        while (end < series.size && series.x[end] <= to) end++
        val count = end - first
        isSparse = count <= columns.count / COLUMNS_PER_DOT
        isDense = count > columns.count
        if (count <= columns.count * SAMPLES_PER_COLUMN) {
            drawSamples(first, end, from, to)
        } else {
            addNeighbor(first - 1, first, from - (to - from))
            drawColumns(from, to, columns)
            addNeighbor(end, end - 1, to + (to - from))
        }
        if (holdsUntil != null && end == series.size) addStep(minOf(holdsUntil, to + (to - from)))
    }

    private fun drawSamples(first: Int, end: Int, from: Double, to: Double) {
        addNeighbor(first - 1, first, from - (to - from))
        for (i in first until end) {
            val value = series.y[i]
            addStep(series.x[i])
            addPoint(series.x[i], value)
            see(value)
        }
        addNeighbor(end, end - 1, to + (to - from))
        if (holdsUntil != null && first > 0) see(series.y[first - 1])
        if (min.isNaN()) for (i in 0 until size) see(y[i])
    }

    /** Extends the line horizontally to [atX], if values hold. */
    private fun addStep(atX: Double) {
        if (holdsUntil != null && size > 0 && !y[size - 1].isNaN()) addPoint(atX, y[size - 1], isCorner = true)
    }

    /** Adds sample [index], which is outside the frame, so that the line to [neighbor] leaves the frame. It is cut off at [limit]. */
    private fun addNeighbor(index: Int, neighbor: Int, limit: Double) {
        if (index !in 0 until series.size) return
        val far = series.x[index]
        if (holdsUntil != null) {
            if (index > neighbor) addStep(minOf(far, limit)) else addPoint(maxOf(far, limit), series.y[index])
            return
        }
        if (neighbor !in 0 until series.size) return
        val near = series.x[neighbor]
        val isBeyond = if (far < near) far < limit else far > limit
        if (!isBeyond) {
            addPoint(far, series.y[index])
            return
        }
        // Distant pixel coordinates would be too large for drawing, so the line is cut off where it is invisible.
        val share = (limit - near) / (far - near)
        addPoint(limit, series.y[neighbor] + (series.y[index] - series.y[neighbor]) * share)
    }

    // x goes backwards somewhere. The line is drawn in the order of the file, and broken where it would run back.
    private fun drawUnordered(from: Double, to: Double, columns: PixelColumns) {
        if (series.x.count { it in from..to } > columns.count * SAMPLES_PER_COLUMN) {
            drawColumns(from, to, columns)
            return
        }
        val margin = to - from
        for (i in 0 until series.size) {
            val place = series.x[i]
            if (i > 0 && place < series.x[i - 1]) addPoint(place, Double.NaN)
            if (place in from - margin..to + margin) addPoint(place, series.y[i]) else addPoint(place, Double.NaN)
            if (place in from..to) see(series.y[i])
        }
    }

    private fun drawColumns(from: Double, to: Double, columns: PixelColumns) {
        downsampling.fill(from, to, columns)
        val width = (to - from) / columns.count
        for (i in 0 until columns.count) {
            if (columns.samples[i] == 0) continue
            val center = from + (i + 0.5) * width
            addStep(center)
            if (columns.beginsInGap(i)) addPoint(center, Double.NaN)
            addColumn(center, columns.first[i], columns.min[i], columns.max[i], columns.last[i])
            if (columns.endsInGap(i)) addPoint(center, Double.NaN)
        }
    }

    private fun addColumn(center: Double, first: Double, least: Double, most: Double, last: Double) {
        if (least.isNaN()) return
        see(least)
        see(most)
        if (!first.isNaN()) addPoint(center, first)
        // This order within the column goes back the least.
        val isRising = first.isNaN() || last.isNaN() || first <= last
        val near = if (isRising) least else most
        val far = if (isRising) most else least
        if (near != first) addPoint(center, near)
        if (far != near) addPoint(center, far)
        if (!last.isNaN() && last != far) addPoint(center, last)
    }

    /** Returns whether point [index] is not a sample, but the end of a held value. */
    fun isCorner(index: Int): Boolean = isCorner[index]

    private fun addPoint(atX: Double, atY: Double, isCorner: Boolean = false) {
        if (size == x.size) {
            x = x.copyOf(maxOf(FIRST_POINTS, size * 2))
            y = y.copyOf(x.size)
            this.isCorner = this.isCorner.copyOf(x.size)
        }
        this.isCorner[size] = isCorner
        x[size] = atX
        y[size++] = if (atY.isFinite()) atY else Double.NaN
    }

    private fun see(value: Double) {
        if (!value.isFinite()) return
        if (!(min <= value)) min = value
        if (!(max >= value)) max = value
    }
}

private const val SAMPLES_PER_COLUMN = 3
private const val COLUMNS_PER_DOT = 12
private const val FIRST_POINTS = 256
