package badlog.viewer.draw.path

import badlog.viewer.draw.curve.Strokes
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor

/**
 * The pixels of a picture that are already drawn.
 *
 * Each pixel is a cell, with [AROUND] more cells on each side of the picture. The outermost cells stand for everything further out; they
 * are always taken, so nothing is drawn there.
 */
internal class TakenPixels {
    private var words = IntArray(0)
    private var wordsPerRow = 0
    private var columns = 0
    private var rows = 0
    private var steps = 0

    /** Frees all pixels of a picture of [width] by [height] pixels. */
    fun begin(width: Int, height: Int) {
        columns = width + 2 * AROUND
        rows = height + 2 * AROUND
        wordsPerRow = (columns ushr WORD_BITS) + 1
        val size = wordsPerRow * rows
        if (words.size == size) words.fill(0) else words = IntArray(size)
        steps = STEPS_PER_PIXEL * columns * rows
        for (column in 0 until columns) {
            take(cellOf(column, 0))
            take(cellOf(column, rows - 1))
        }
        for (row in 0 until rows) {
            take(cellOf(0, row))
            take(cellOf(columns - 1, row))
        }
    }

    /** Returns whether ([x], [y]), in pixels, is in a cell that is not one of the outermost. */
    fun isInside(x: Double, y: Double): Boolean = x >= FIRST && x < columns - AROUND - 1 && y >= FIRST && y < rows - AROUND - 1

    /** Returns the cell of a place that [isInside]. */
    fun innerCellOf(x: Double, y: Double): Int = cellOf((x + AROUND).toInt(), (y + AROUND).toInt())

    /** Returns the cell of any place. */
    fun cellOf(x: Double, y: Double): Int = cellOf(indexOf(x, columns), indexOf(y, rows))

    private fun cellOf(column: Int, row: Int) = row * (wordsPerRow shl WORD_BITS) + column

    private fun indexOf(place: Double, cells: Int): Int = if (place < FIRST) {
        0
    } else if (place >= cells - AROUND - 1) {
        cells - 1
    } else {
        (place + AROUND).toInt()
    }

    private fun isOut(first: Int, last: Int, cells: Int) = last == 0 || first == cells - 1

    /**
     * Returns whether all pixels between [left] and [right], [top] and [bottom] are taken. Also returns false if checking would take longer
     * than drawing [count] samples.
     */
    fun isDone(left: Double, right: Double, bottom: Double, top: Double, count: Int): Boolean {
        val first = indexOf(left, columns)
        val last = indexOf(right, columns)
        val low = indexOf(bottom, rows)
        val high = indexOf(top, rows)
        if (isOut(first, last, columns) || isOut(high, low, rows)) return true
        if ((low - high + 1) * ((last - first ushr WORD_BITS) + 2) > WORDS_PER_SAMPLE * count) return false
        for (row in high..low) if (!isTaken(cellOf(first, row), cellOf(last, row))) return false
        return true
    }

    private fun isTaken(first: Int, last: Int): Boolean {
        val lastWord = last ushr WORD_BITS
        var free = -1 shl first
        for (word in (first ushr WORD_BITS)..lastWord) {
            if (word == lastWord) free = free and (-1 ushr -1 - last)
            if (words[word].inv() and free != 0) return false
            free = -1
        }
        return true
    }

    /** Takes [cell], and returns whether it was free. */
    fun take(cell: Int): Boolean {
        val bit = 1 shl cell
        val word = words[cell ushr WORD_BITS]
        words[cell ushr WORD_BITS] = word or bit
        return word and bit == 0
    }

    /**
     * Takes all visible pixels on the way from ([fromX], [fromY]) to ([toX], [toY]), which is in [cell]. Returns whether any of them was
     * free.
     *
     * @param isInside whether both ends are in inner cells.
     */
    fun takeSegment(fromX: Double, fromY: Double, toX: Double, toY: Double, cell: Int, isInside: Boolean): Boolean {
        var isNew = take(cell)
        val right = toX - fromX
        val down = toY - fromY
        val far = maxOf(abs(right), abs(down))
        if (far <= 1) return isNew
        val count = ceil(far)
        var start = 1.0
        var end = count - 1
        if (!isInside) {
            start = maxOf(start, ceil(enter(fromX, fromY, right, down) * count))
            end = minOf(end, floor((1 - enter(toX, toY, -right, -down)) * count))
        }
        val between = (end - start + 1).toInt()
        steps -= maxOf(0, between)
        // The million long ways of a path that jumps a million times would take too long. Then only its samples count.
        if (steps < 0) return isNew
        // Integers keep each step to a few instructions.
        val stepX = (right / count * FINE).toInt()
        val stepY = (down / count * FINE).toInt()
        var x = ((fromX + right * start / count + AROUND) * FINE).toInt()
        var y = ((fromY + down * start / count + AROUND) * FINE).toInt()
        for (i in 0 until between) {
            if (take(cellOf(x shr FINE_BITS, y shr FINE_BITS))) isNew = true
            x += stepX
            y += stepY
        }
        return isNew
    }

    /**
     * Returns the fraction of the way from ([x], [y]) to the inner cells; infinity if it never reaches them. The way goes [right] and
     * [down].
     */
    private fun enter(x: Double, y: Double, right: Double, down: Double) = maxOf(enter(x, right, columns), enter(y, down, rows))

    private fun enter(from: Double, length: Double, cells: Int): Double {
        val end = (cells - AROUND - 1).toDouble()
        if (from >= FIRST && from < end) return 0.0
        val part = ((if (from < FIRST) FIRST else end) - from) / length
        return if (part >= 0) part else Double.POSITIVE_INFINITY
    }

    /** Adds the rows of taken pixels with at most [gap] free ones between them to [strokes], if given. Returns the number of rows. */
    fun runs(strokes: Strokes?, gap: Int): Int {
        var count = 0
        for (row in AROUND until rows - AROUND) {
            val first = row * wordsPerRow
            val y = row - AROUND + HALF
            var end = NONE
            var before = 0
            for (column in 0..columns - AROUND step WORD) {
                var word = words[first + (column ushr WORD_BITS)]
                if (column == 0) word = word and (-1 shl AROUND)
                if (column + WORD > columns - AROUND) word = word and (1 shl columns - AROUND) - 1
                var changes = word xor (word shl 1 or before)
                before = word ushr WORD - 1
                while (changes != 0) {
                    val bit = changes.countTrailingZeroBits()
                    val x = column + bit - AROUND
                    changes = changes and changes - 1
                    if (word ushr bit and 1 == 0) {
                        end = x
                    } else if (end == NONE || x - end > gap) {
                        if (end != NONE) strokes?.endRun(end, y)
                        strokes?.add(x.toDouble(), y)
                        count++
                    }
                }
            }
            if (end != NONE) strokes?.endRun(end, y)
        }
        return count
    }

    private fun Strokes.endRun(x: Int, y: Double) {
        add(x.toDouble(), y)
        lift()
    }
}

private const val NONE = -1
private const val WORD_BITS = 5
private const val WORD = 1 shl WORD_BITS
private const val HALF = 0.5

/** The width of the margin of cells around the picture. Half of a line in the inner ones may still be visible. */
private const val AROUND = 2

/** The start of the inner cells. */
private const val FIRST = 1.0 - AROUND

/** The bits of a fraction of a pixel. With so many, a line of thousands of steps ends less than a pixel off. */
private const val FINE_BITS = 15
private const val FINE = 1 shl FINE_BITS

/** The number of words that are worth reading for each sample that they may save. */
private const val WORDS_PER_SAMPLE = 8

/** The maximum number of lines that may cross each pixel, on average. */
private const val STEPS_PER_PIXEL = 4
