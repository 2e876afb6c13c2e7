package badlog.core.bag

import badlog.core.text.CR
import badlog.core.text.LF
import badlog.core.text.TAB

/** The first lines of a file from the titles on. The rows show whether a line of titles is damaged or merely unusual. */
internal class FirstLines(private val pending: PendingBytes, private val cellReader: CellReader) {
    /**
     * A line without its end.
     *
     * @property next the start of the next line.
     * @property cells the number of its cells; 0 if its quotes or bytes cannot be in a row.
     * @property numbers the number of cells with a number, `true` or `false`.
     * @property texts the number of cells with a text.
     */
    class Line(val from: Int, val end: Int, val next: Int, val cells: Int, val numbers: Int, val texts: Int) {
        /** Whether it is a line of titles rather than a row: all of its cells are texts. */
        val isTitles: Boolean get() = texts == cells
    }

    private val splitter = RowSplitter()

    /** The line of titles, followed by the examined lines. */
    val lines = ArrayList<Line>()

    /** The number of cells in most of the lines after the titles; 0 if that is not clear. */
    var width = 0
        private set

    /** Whether some of them are rows with numbers. */
    var hasRows = false
        private set

    /** Whether the bytes are a picture, an archive or a program: even a damaged log has more text than those. */
    var isBinary = false
        private set

    /** Examines the lines from the first pending byte on. Returns false if more of them are needed and [isEnd] is false. */
    fun look(isEnd: Boolean): Boolean {
        lines.clear()
        val bytes = pending.bytes
        val limit = minOf(pending.end, pending.start + MAX_BYTES)
        var at = pending.start
        var rows = 0
        while (rows <= ROWS) {
            val end = lineEndIn(bytes, at, limit)
            if (end == limit) {
                if (!isEnd && limit == pending.end) return false
                break
            }
            val next = afterLineEnd(bytes, end, pending.end, isEnd)
            if (next == RowScanner.INCOMPLETE) return false
            if (end > at) {
                val line = lineOf(bytes, at, end, next)
                lines += line
                if (line.cells > 0) rows++
            }
            // After a line that ends at a NUL, go on from that NUL.
            at = if (next == end) end + 1 else next
        }
        val controls = (pending.start until at).count { isControl(bytes[it]) }
        isBinary = controls >= MIN_CONTROLS && controls * MIN_TEXT > at - pending.start
        findWidth()
        return true
    }

    private fun lineOf(bytes: ByteArray, from: Int, end: Int, next: Int): Line {
        val count = splitter.split(bytes, from, end, RowSplitter.Quotes.STRICT)
        val isRow = !splitter.isOpen && !splitter.isMalformed && !hasControls(bytes, from, end)
        val kinds = List(count) { cellReader.read(bytes, splitter.starts[it], splitter.ends[it]) }
        val texts = kinds.count { it == CellKind.TEXT }
        return Line(from, end, next, if (isRow) count else 0, kinds.count { it != CellKind.EMPTY } - texts, texts)
    }

    private fun findWidth() {
        val full = lines.drop(1).filter { it.cells > 0 }
        // A piece of the titles, split off by damage, has no numbers.
        val rows = full.filter { it.numbers > 0 }.ifEmpty { full }
        val counts = rows.groupingBy { it.cells }.eachCount()
        val own = counts[lines.firstOrNull()?.cells] ?: 0
        val best = counts.maxByOrNull { it.value * MAX_CELLS + it.key }
        width = when {
            best == null -> 0
            own * CLEARLY >= best.value -> lines[0].cells
            else -> best.key
        }
        val numeric = rows.count { it.cells == width && it.numbers > 0 }
        hasRows = width > 0 && numeric >= minOf(2, lines.size - 1) && (width > 1 || numeric * 2 >= lines.size)
    }

    /**
     * Returns whether [line], the first after the titles, holds the columns' units. A line of units has only short texts, rows with numbers
     * below it, and at least one text above a column of nothing but numbers.
     */
    fun isUnitLine(line: Line): Boolean {
        val rows = lines.drop(2).filter { it.cells == line.cells }
        if (line.numbers > 0 || line.texts == 0 || rows.size < 2 || rows.any { it.numbers == 0 }) return false
        val bytes = pending.bytes
        splitter.split(bytes, line.from, line.end, RowSplitter.Quotes.STRICT)
        val filled = (0 until line.cells).filter { cellReader.read(bytes, splitter.starts[it], splitter.ends[it]) == CellKind.TEXT }
        if (filled.any { splitter.ends[it] - splitter.starts[it] > MAX_UNIT_LENGTH }) return false
        val above = rows.map { row ->
            splitter.split(bytes, row.from, row.end, RowSplitter.Quotes.STRICT)
            filled.map { cellReader.read(bytes, splitter.starts[it], splitter.ends[it]) }
        }
        return filled.indices.any { index -> above.all { it[index] == CellKind.NUMBER || it[index] == CellKind.EMPTY } }
    }

    /** Returns the number of lines after the first that have [width] cells. */
    fun rowsOf(width: Int): Int = lines.drop(1).count { it.cells == width }

    companion object {
        /** This many rows are examined. */
        private const val ROWS = 20
        private const val MAX_BYTES = 1 shl 20
        private const val MAX_UNIT_LENGTH = 16
        private const val CLEARLY = 3
        private const val MAX_CELLS = 1 shl 16

        /** Every ninth random byte is a control character; in text with a few damaged places, fewer than one in [MIN_TEXT] is. */
        private const val MIN_TEXT = 20
        private const val MIN_CONTROLS = 16

        /** Returns whether there are bytes that do not occur in text. */
        fun hasControls(bytes: ByteArray, from: Int, until: Int): Boolean =
            (from until until).any { bytes[it] in 1..31 && bytes[it].toInt() != TAB }

        // Except NUL: a loss of power may leave thousands of them.
        private fun isControl(byte: Byte) = byte in 1..31 && byte.toInt() != TAB && byte.toInt() != LF && byte.toInt() != CR
    }
}
