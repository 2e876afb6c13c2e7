package badlog.plot.path

import badlog.plot.curve.Scale
import badlog.plot.curve.Strokes
import badlog.rules.path.Trail
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Draws trails pixel by pixel: every pixel that contains a sample is drawn, in the order of the samples, but none twice. So a picture
 * needs at most as many strokes as it has pixels, however many samples there are; each sample is only visited.
 */
public class TrailDrawing {
    private var taken = IntArray(0)
    private var columns = 0
    private var rows = 0
    private var steps = 0

    /**
     * Adds the samples of [trail] from [start] until [end] to [strokes], which is cleared first.
     *
     * @param isJoined whether samples are joined by lines; otherwise each is a dot.
     */
    public fun draw(trail: Trail, start: Int, end: Int, x: Scale, y: Scale, width: Int, height: Int, isJoined: Boolean, strokes: Strokes) {
        // The visible pixels are surrounded by a frame of invisible ones, so that nothing there is drawn twice either.
        columns = width + 2
        rows = height + 2
        val words = (columns * rows + WORD - 1) / WORD
        if (taken.size == words) taken.fill(0) else taken = IntArray(words)
        steps = STEPS_PER_PIXEL * columns * rows
        strokes.begin()
        var lastCell = NONE
        var lastX = 0.0
        var lastY = 0.0
        var isDown = false
        for (i in start until end) {
            val px = x.placeOf(trail.x[i])
            val py = y.placeOf(trail.y[i])
            if (px.isNaN() || py.isNaN()) {
                if (isDown) strokes.lift()
                isDown = false
                lastCell = NONE
                continue
            }
            val column = cellOf(px, width)
            val row = cellOf(py, height)
            val cell = row * columns + column
            val isSeen = column in 1..width && row in 1..height
            if (cell == lastCell && isSeen) continue
            if (!isJoined) {
                if (isSeen && take(cell)) strokes.dot(px, py)
            } else if (lastCell == NONE) {
                // A last sample that no other follows is still visible.
                if (isSeen && take(cell)) strokes.dot(px, py)
            } else if (cell != lastCell && takeWay(lastX, lastY, px, py)) {
                if (!isDown) strokes.add(lastX, lastY)
                strokes.add(px, py)
                isDown = true
            } else {
                if (isDown) strokes.lift()
                isDown = false
            }
            lastCell = cell
            lastX = px
            lastY = py
        }
        strokes.lift()
        strokes.isDense = strokes.count > 0 && strokes.endOf(strokes.count - 1) > 2 * DENSE
    }

    private fun cellOf(place: Double, count: Int): Int = if (place < 0) {
        0
    } else if (place >= count) {
        count + 1
    } else {
        place.toInt() + 1
    }

    private fun take(cell: Int): Boolean {
        val bit = 1 shl (cell and WORD - 1)
        val word = cell / WORD
        if (taken[word] and bit != 0) return false
        taken[word] = taken[word] or bit
        return true
    }

    /** Takes all visible pixels on the way from ([fromX], [fromY]) to ([toX], [toY]). Returns whether any of them was free. */
    private fun takeWay(fromX: Double, fromY: Double, toX: Double, toY: Double): Boolean {
        val right = toX - fromX
        val down = toY - fromY
        val count = ceil(maxOf(abs(right), abs(down), 1.0))
        val first = maxOf(0.0, enter(fromX, right, columns), enter(fromY, down, rows))
        val last = minOf(1.0, leave(fromX, right, columns), leave(fromY, down, rows))
        var step = ceil(first * count)
        val end = floor(last * count)
        // A trail that jumps a million times would need a million such ways; then only the end points count.
        steps -= maxOf(0.0, end - step).toInt()
        if (steps < 0) step = maxOf(step, count)
        var isNew = false
        while (step <= end) {
            val column = cellOf(fromX + right * step / count, columns - 2)
            if (take(cellOf(fromY + down * step / count, rows - 2) * columns + column)) isNew = true
            step++
        }
        return isNew
    }

    /**
     * Returns the fraction of a way of [length] from [from] at which it reaches the first of [cells] cells, which begin at -1; see [leave]
     * for the end of the last.
     */
    private fun enter(from: Double, length: Double, cells: Int) = when {
        length > 0 -> (-1 - from) / length
        length < 0 -> (cells - 1 - from) / length
        else -> Double.NEGATIVE_INFINITY
    }

    private fun leave(from: Double, length: Double, cells: Int) = if (length ==
        0.0
    ) {
        Double.POSITIVE_INFINITY
    } else {
        enter(from, -length, cells) * -1
    }

    private companion object {
        const val WORD = 32
        const val NONE = -1

        /** More points than these are drawn in the thinnest lines. */
        const val DENSE = 20_000

        /** The maximum number of lines that may cross each pixel, on average. */
        const val STEPS_PER_PIXEL = 4
    }
}
