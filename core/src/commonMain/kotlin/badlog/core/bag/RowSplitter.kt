package badlog.core.bag

import badlog.core.text.COMMA
import badlog.core.text.QUOTE

/** Finds the cells of a row that is not plain, under several readings of its quotes. */
internal class RowSplitter {
    /** The start and the end of each cell that was last found, without its quotes. Only as many of them are valid as [split] returned. */
    var starts = IntArray(16)
        private set
    var ends = IntArray(16)
        private set

    /** Whether each cell was quoted. */
    var quoted = BooleanArray(16)
        private set

    /** Whether the bytes ended inside quotes. */
    var isOpen = false
        private set

    /** Whether there was a quote where RFC 4180 allows none. */
    var isMalformed = false
        private set

    /** The readings of quotes. */
    enum class Quotes {
        /** RFC 4180: a quote opens at a cell's start and closes at the next single quote. A doubled quote stands for one. */
        STRICT,

        /** A quote opens at a cell's start and closes only before a comma or the end. The original badlog never doubled quotes. */
        LENIENT,

        /** A quote is a character like any other. */
        LITERAL,
    }

    private var count = 0

    /** Splits the bytes from [from] until [until], which contain no line end outside quotes. Returns the number of cells. */
    fun split(bytes: ByteArray, from: Int, until: Int, quotes: Quotes): Int {
        count = 0
        isOpen = false
        isMalformed = false
        var at = from
        while (true) {
            val opens = quotes != Quotes.LITERAL && at < until && bytes[at].toInt() == QUOTE
            at = if (opens) quotedCell(bytes, at, until, quotes) else plainCell(bytes, at, until)
            if (at >= until) return count
            at++
            if (at == until) {
                add(at, at, false)
                return count
            }
        }
    }

    private fun plainCell(bytes: ByteArray, from: Int, until: Int): Int {
        var at = from
        while (at < until && bytes[at].toInt() != COMMA) {
            if (bytes[at].toInt() == QUOTE) isMalformed = true
            at++
        }
        add(from, at, false)
        return at
    }

    private fun quotedCell(bytes: ByteArray, from: Int, until: Int, quotes: Quotes): Int {
        var at = from + 1
        while (at < until) {
            if (bytes[at].toInt() == QUOTE) {
                val next = if (at + 1 < until) bytes[at + 1].toInt() else COMMA
                if (next == COMMA) {
                    add(from + 1, at, true)
                    return at + 1
                }
                if (next == QUOTE && quotes == Quotes.STRICT) at++ else isMalformed = true
            }
            at++
        }
        isOpen = true
        add(from + 1, until, true)
        return until
    }

    /**
     * Joins cells that were split at a quote and a comma inside one text. In `"he said "a", ok"`, a cell that ends in a quote without
     * having begun with one belongs to the quoted cell before it. Stops at [wanted] cells.
     *
     * @return the number of cells that are left.
     */
    fun mergeTornQuotes(bytes: ByteArray, wanted: Int): Int {
        var i = 1
        while (i < count && count > wanted) {
            val isSplitOff = !quoted[i] && ends[i] > starts[i] && bytes[ends[i] - 1].toInt() == QUOTE
            val opening = if (isSplitOff) quotedBefore(i) else -1
            if (opening >= 0 && count - (i - opening) >= wanted) {
                ends[opening] = ends[i] - 1
                remove(opening + 1, i - opening)
                i = opening + 1
            } else {
                i++
            }
        }
        return count
    }

    private fun quotedBefore(cell: Int): Int {
        var i = cell - 1
        while (i >= 0 && !quoted[i]) i--
        return i
    }

    private fun remove(from: Int, cells: Int) {
        starts.copyInto(starts, from, from + cells, count)
        ends.copyInto(ends, from, from + cells, count)
        quoted.copyInto(quoted, from, from + cells, count)
        count -= cells
    }

    private fun add(start: Int, end: Int, isQuoted: Boolean) {
        if (count == starts.size) {
            starts = starts.copyOf(count * 2)
            ends = ends.copyOf(count * 2)
            quoted = quoted.copyOf(count * 2)
        }
        starts[count] = start
        ends[count] = end
        quoted[count] = isQuoted
        count++
    }
}
