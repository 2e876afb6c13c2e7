package badlog.plot.path

import badlog.plot.curve.Scale
import badlog.plot.curve.Strokes
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Draws a trail pixel by pixel: every pixel that contains a sample is drawn, in the order of the samples, but none twice. So a picture
 * needs at most as many strokes as it has pixels, however many samples there are. Blocks of the [pyramid] that are out of sight, within one
 * pixel or where everything is drawn already are skipped; areas that are filled become rows of pixels.
 */
internal class TrailDrawing(private val pyramid: TrailPyramid) {
    private var taken = IntArray(0)
    private var columns = 0
    private var rows = 0
    private var steps = 0

    /**
     * Adds the samples from [start] until [end] to [strokes], which is cleared first.
     *
     * @param isJoined whether samples are joined by lines; otherwise each is a dot.
     */
    fun draw(start: Int, end: Int, x: Scale, y: Scale, width: Int, height: Int, isJoined: Boolean, strokes: Strokes) {
        begin(width, height)
        strokes.begin()
        val trail = pyramid.trail
        var lastCell = NONE
        var lastX = 0.0
        var lastY = 0.0
        var isDown = false
        pyramid.visit(start, end, { boxes, at, count ->
            isDone(
                left = cellOf(x.placeOf(boxes[at]), columns),
                right = cellOf(x.placeOf(boxes[at + 1]), columns),
                bottom = cellOf(y.placeOf(boxes[at + 2]), rows),
                top = cellOf(y.placeOf(boxes[at + 3]), rows),
                count,
            )
        }, { i ->
            val px = x.placeOf(trail.x[i])
            val py = y.placeOf(trail.y[i])
            val cell = if (px.isNaN() || py.isNaN()) NONE else cellOf(py, rows) * columns + cellOf(px, columns)
            // Within a pixel, the line continues from where it entered it.
            if (cell == NONE || cell != lastCell) {
                strokes.lift()
                isDown = false
                lastCell = cell
                lastX = px
                lastY = py
            }
        }) { i ->
            val px = x.placeOf(trail.x[i])
            val py = y.placeOf(trail.y[i])
            if (px.isNaN() || py.isNaN()) {
                strokes.lift()
                isDown = false
                lastCell = NONE
            } else {
                val column = cellOf(px, columns)
                val row = cellOf(py, rows)
                val cell = row * columns + column
                // Out of sight, places in the same cell can be far apart.
                if (cell != lastCell || isOut(column, column, columns) || isOut(row, row, rows)) {
                    if (!isJoined || lastCell == NONE) {
                        // A last sample that no other follows is still visible.
                        if (take(cell)) strokes.dot(px, py)
                    } else if (takeWay(lastX, lastY, px, py, cell)) {
                        if (!isDown) strokes.add(lastX, lastY)
                        strokes.add(px, py)
                        isDown = true
                    } else {
                        strokes.lift()
                        isDown = false
                    }
                    lastCell = cell
                    lastX = px
                    lastY = py
                }
            }
        }
        strokes.lift()
        val points = if (strokes.count > 0) strokes.endOf(strokes.count - 1) / 2 else 0
        strokes.isDense = points > DENSE
        // Filled areas need far fewer strokes this way.
        if (strokes.isDense && runs(null) < points / 2) {
            strokes.begin()
            runs(strokes)
        }
    }

    /** Takes the outermost cells, which stand for everything too far out of sight for its lines to be visible. So nothing is drawn there. */
    private fun begin(width: Int, height: Int) {
        columns = width + 2 * AROUND
        rows = height + 2 * AROUND
        val words = (columns * rows ushr WORD_BITS) + 1
        if (taken.size == words) taken.fill(0) else taken = IntArray(words)
        steps = STEPS_PER_PIXEL * columns * rows
        for (column in 0 until columns) {
            take(column)
            take((rows - 1) * columns + column)
        }
        for (row in 0 until rows) {
            take(row * columns)
            take(row * columns + columns - 1)
        }
    }

    /** Which of so many [cells] contains [place]; the first and the last one contain everything further out. */
    private fun cellOf(place: Double, cells: Int): Int = if (place < 1 - AROUND) {
        0
    } else if (place >= cells - AROUND - 1) {
        cells - 1
    } else {
        (place + AROUND).toInt()
    }

    private fun isOut(first: Int, last: Int, cells: Int) = last == 0 || first == cells - 1

    /** Whether nothing is left to draw in a box of cells. False also if finding out would take longer than [count] steps. */
    private fun isDone(left: Int, right: Int, bottom: Int, top: Int, count: Int): Boolean {
        if (isOut(left, right, columns) || isOut(top, bottom, rows)) return true
        if ((bottom - top + 1) * ((right - left ushr WORD_BITS) + 2) > WORDS_PER_STEP * count) return false
        for (row in top..bottom) if (!isTaken(row * columns + left, row * columns + right)) return false
        return true
    }

    private fun isTaken(first: Int, last: Int): Boolean {
        val lastWord = last ushr WORD_BITS
        var free = -1 shl first
        for (word in (first ushr WORD_BITS)..lastWord) {
            if (word == lastWord) free = free and (-1 ushr -1 - last)
            if (taken[word].inv() and free != 0) return false
            free = -1
        }
        return true
    }

    private fun take(cell: Int): Boolean {
        val bit = 1 shl cell
        val word = cell ushr WORD_BITS
        if (taken[word] and bit != 0) return false
        taken[word] = taken[word] or bit
        return true
    }

    /** Takes all visible pixels on the way from ([fromX], [fromY]) to ([toX], [toY]), which is in [cell]. Returns whether any of them was free. */
    private fun takeWay(fromX: Double, fromY: Double, toX: Double, toY: Double, cell: Int): Boolean {
        var isNew = take(cell)
        val right = toX - fromX
        val down = toY - fromY
        val count = ceil(maxOf(abs(right), abs(down)))
        if (count <= 1) return isNew
        val start = maxOf(1.0, ceil(enter(fromX, fromY, right, down) * count))
        val end = minOf(count - 1, floor((1 - enter(toX, toY, -right, -down)) * count))
        val between = (end - start + 1).toInt()
        steps -= maxOf(0, between)
        // A path that jumps about a million times would need a million long ways: then only its samples count.
        if (steps < 0) return isNew
        // With integers, each step takes a few instructions.
        val stepX = (right / count * FINE).toInt()
        val stepY = (down / count * FINE).toInt()
        var x = ((fromX + right * start / count + AROUND) * FINE).toInt()
        var y = ((fromY + down * start / count + AROUND) * FINE).toInt()
        for (i in 0 until between) {
            if (take((y shr FINE_BITS) * columns + (x shr FINE_BITS))) isNew = true
            x += stepX
            y += stepY
        }
        return isNew
    }

    /** At which fraction of the way that goes [right] and [down] from ([x], [y]) the drawn cells begin; infinity for never. */
    private fun enter(x: Double, y: Double, right: Double, down: Double) = maxOf(enter(x, right, columns), enter(y, down, rows))

    private fun enter(from: Double, length: Double, cells: Int): Double {
        val first = 1.0 - AROUND
        val end = cells + first - 2
        if (from >= first && from < end) return 0.0
        val part = ((if (from < first) first else end) - from) / length
        return if (part >= 0) part else Double.POSITIVE_INFINITY
    }

    /** Adds the rows of adjacent taken pixels to [strokes], if given. Returns how many there are. */
    private fun runs(strokes: Strokes?): Int {
        var count = 0
        for (row in AROUND until rows - AROUND) {
            val start = row * columns
            val end = start + columns - AROUND
            var cell = start + AROUND
            var isOn = false
            while (cell <= end) {
                val word = if (cell == end) 0 else taken[cell ushr WORD_BITS]
                val isTaken = word shr cell and 1 != 0
                if (isTaken != isOn) {
                    isOn = isTaken
                    strokes?.add((cell - start - AROUND).toDouble(), row - AROUND + HALF)
                    if (isOn) count++ else strokes?.lift()
                }
                // Most words are completely taken, or completely free.
                cell += if (cell and WORD - 1 == 0 && cell + WORD <= end && (word == 0 || word == -1)) WORD else 1
            }
        }
        return count
    }

    private companion object {
        const val WORD_BITS = 5
        const val WORD = 1 shl WORD_BITS
        const val NONE = -1
        const val HALF = 0.5

        /** The width of the frame of cells around the picture. In the inner ones, half of a line may still be visible. */
        const val AROUND = 2

        /** Fractions of a pixel so small that a line of thousands of steps ends less than a pixel off. */
        const val FINE_BITS = 15
        const val FINE = 1 shl FINE_BITS

        /** How many words of cells are worth looking at for each step that this may save. */
        const val WORDS_PER_STEP = 8

        /** More points than these are drawn in the thinnest lines. */
        const val DENSE = 20_000

        /** The maximum number of lines that may cross each pixel, on average. */
        const val STEPS_PER_PIXEL = 4
    }
}
