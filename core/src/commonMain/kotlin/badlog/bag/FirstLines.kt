package badlog.bag

import badlog.text.CR
import badlog.text.LF
import badlog.text.TAB

/** What the first lines from the titles on look like; the rows that follow show whether a line of titles is damaged or only odd. */
internal class FirstLines(private val pending: PendingBytes, private val cellReader: CellReader) {
    /**
     * A line without its end.
     *
     * @property next where the next line begins.
     * @property cells how many cells it has; 0 where its quotes or its bytes are not those of a row.
     * @property numbers how many of them are numbers, or true or false.
     * @property texts how many of them are texts.
     */
    class Line(val from: Int, val end: Int, val next: Int, val cells: Int, val numbers: Int, val texts: Int) {
        /** Whether it is a line of titles rather than a row: all of its cells are texts. */
        val isTitles: Boolean get() = texts == cells
    }

    private val splitter = RowSplitter()

    /** The titles, and as many lines after them as are looked at. */
    val lines = ArrayList<Line>()

    /** How many cells most of the lines after the titles have; 0 where that is not clear. */
    var width = 0
        private set

    /** Whether among them are rows with numbers. */
    var hasRows = false
        private set

    /** Whether they are the bytes of a picture, an archive or a program: damage leaves more text than that. */
    var isBinary = false
        private set

    /** Looks at the lines from the pending byte on; false where more of them are needed, and [isEnd] does not say that there are none. */
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
            // A line that ends at a NUL goes on there.
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
        // What damage has torn off the titles has no numbers.
        val rows = full.filter { it.numbers > 0 }.ifEmpty { full }
        val counts = rows.groupingBy { it.cells }.eachCount()
        val own = counts[lines.firstOrNull()?.cells] ?: 0
        val best = counts.maxByOrNull { it.value * MOST_CELLS + it.key }
        width = when {
            best == null -> 0
            own * CLEARLY >= best.value -> lines[0].cells
            else -> best.key
        }
        val numeric = rows.count { it.cells == width && it.numbers > 0 }
        hasRows = width > 0 && numeric >= minOf(2, lines.size - 1) && (width > 1 || numeric * 2 >= lines.size)
    }

    /** How many of the lines after the first have [width] cells. */
    fun rowsOf(width: Int): Int = lines.drop(1).count { it.cells == width }

    companion object {
        /** So many rows are looked at. */
        private const val ROWS = 20
        private const val MAX_BYTES = 1 shl 20
        private const val CLEARLY = 3
        private const val MOST_CELLS = 1 shl 16

        /** Of bytes by chance every ninth is a control character; of text with a few damaged places not one in [MIN_TEXT]. */
        private const val MIN_TEXT = 20
        private const val MIN_CONTROLS = 16

        /** Whether there are bytes that no text has. */
        fun hasControls(bytes: ByteArray, from: Int, until: Int): Boolean =
            (from until until).any { bytes[it] in 1..31 && bytes[it].toInt() != TAB }

        // Not NUL, of which a loss of power may leave thousands.
        private fun isControl(byte: Byte) = byte in 1..31 && byte.toInt() != TAB && byte.toInt() != LF && byte.toInt() != CR
    }
}
