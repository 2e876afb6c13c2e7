package badlog.core.bag

import badlog.core.bag.RowSplitter.Quotes
import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.text.COMMA
import badlog.core.text.DOT
import badlog.core.text.NINE
import badlog.core.text.NUL
import badlog.core.text.QUOTE
import badlog.core.text.TextDecoder
import badlog.core.text.ZERO
import badlog.core.text.isLetterOrDigit

/**
 * Reads the rows that [RowScanner] cannot read: quoted, cut, split, too short or too long ones. A line that is a complete row by itself is
 * never merged into a damaged one before it.
 *
 * @param endsInNewline whether every whole row of this file ends in a newline, as a bag's does, so that a last row
 *   without one is cut.
 */
internal class RowRepair(
    private val pending: PendingBytes,
    private val cells: RowCells,
    private val reader: CellReader,
    private val columns: Array<ColumnBuilder>,
    private val decoder: TextDecoder,
    private val problems: ProblemList,
    private val endsInNewline: Boolean,
) {
    private val splitter = RowSplitter()
    private val copy = CellCopy(cells, splitter, reader, columns)

    /** The bytes of the row's text cells, unescaped; the starts and ends of cells are indices into it. */
    val text: ByteArray get() = copy.text

    /** Whether the last call of [repair] put a row into the cells. */
    var hasRow = false
        private set

    /** The number of physical lines that the last call of [repair] consumed. */
    var linesPassed = 0
        private set

    private val line get() = pending.line

    // For each cell of a row with an open quote, whether it is a number.
    private val hasNumber = BooleanArray(cells.columns)

    /**
     * Reads one row at the start of the pending bytes, or skips blank or damaged lines there. The bytes begin with the start of a line.
     *
     * @param isEnd whether no more bytes will follow.
     * @param row the number of rows so far.
     * @return where the next row begins, or [RowScanner.INCOMPLETE] when more bytes are needed to decide.
     */
    fun repair(isEnd: Boolean, row: Int): Int {
        val bytes = pending.bytes
        val from = pending.start
        val until = pending.end
        hasRow = false
        linesPassed = 0
        val end = lineEndIn(bytes, from, until)
        if (end == until) return if (isEnd) tail(bytes, from, until, endsInNewline) else RowScanner.INCOMPLETE
        if (bytes[end].toInt() == NUL) return hole(bytes, from, end)
        val next = afterLineEnd(bytes, end, until, isEnd)
        if (next == RowScanner.INCOMPLETE) return next
        linesPassed = 1
        if (end == from) {
            linesPassed = 0
            return pending.skipBlankLines(end, next, problems)
        }
        val strictCount = splitter.split(bytes, from, end, Quotes.STRICT)
        if (!splitter.isOpen && !splitter.isMalformed && strictCount == cells.columns) return take(bytes, true, next)
        if (splitter.isOpen && !splitter.isMalformed) {
            findNumbers(bytes, strictCount - 1)
            val after = quotedLines(bytes, from, next, until, isEnd)
            if (after != NO_MATCH) return after
        }
        if (readWithOddQuotes(bytes, from, end, mayBeOpen = true)) return take(bytes, false, next)
        if (pending.isAfterHole) return dropFragment(bytes, from, end, next)
        val after = joinedLines(bytes, from, end, next, until, isEnd)
        return when {
            after != NO_MATCH -> after
            continuesText(bytes, from, end, row - 1) -> next
            else -> takeUneven(bytes, from, end, next)
        }
    }

    /**
     * Reads a row with newlines inside a quoted cell, as RFC 4180 allows. Returns where the next row begins, or [NO_MATCH] if it is not
     * one.
     */
    private fun quotedLines(bytes: ByteArray, from: Int, secondLine: Int, until: Int, isEnd: Boolean): Int {
        var start = secondLine
        var holdsRows = false
        for (lines in 2..MAX_LINES) {
            val end = lineEndIn(bytes, start, until)
            if (end - from > MAX_BYTES) return NO_MATCH
            if (end == until && !isEnd) return RowScanner.INCOMPLETE
            // With one topic every line is a row.
            if (start < end && (cells.columns == 1 || isCompleteRow(bytes, start, end))) {
                if (cells.columns > 1 && hasSameNumbers(bytes)) return NO_MATCH
                holdsRows = true
            }
            if (end == until) return if (holdsRows) NO_MATCH else tail(bytes, from, until, endsInNewline)
            if (bytes[end].toInt() == NUL) return NO_MATCH
            val count = splitter.split(bytes, from, end, Quotes.STRICT)
            val next = afterLineEnd(bytes, end, until, isEnd)
            if (next == RowScanner.INCOMPLETE) return next
            if (!splitter.isOpen) {
                if (splitter.isMalformed || count != cells.columns) return NO_MATCH
                linesPassed = lines
                return take(bytes, true, next)
            }
            start = next
        }
        return NO_MATCH
    }

    private fun findNumbers(bytes: ByteArray, count: Int) {
        for (i in hasNumber.indices) hasNumber[i] = i < count && kindOf(bytes, i) == CellKind.NUMBER
    }

    // Returns whether the line has no text where the row has a number. A line of a quoted text may have as many cells as a row, but seldom
    // a number wherever the row has one.
    private fun hasSameNumbers(bytes: ByteArray): Boolean = hasNumber.indices.none { hasNumber[it] && kindOf(bytes, it) == CellKind.TEXT }

    private fun kindOf(bytes: ByteArray, cell: Int): Int = reader.read(bytes, splitter.starts[cell], splitter.ends[cell])

    /**
     * Tries readings of quotes that were never escaped, until one gives the row its right number of cells.
     *
     * @param mayBeOpen whether a quote that nothing closes may be a character like any other.
     */
    private fun readWithOddQuotes(bytes: ByteArray, from: Int, end: Int, mayBeOpen: Boolean): Boolean {
        val wanted = cells.columns
        val fits = (splitter.split(bytes, from, end, Quotes.LENIENT) == wanted && !splitter.isOpen) ||
            (splitter.mergeTornQuotes(bytes, wanted) == wanted && !splitter.isOpen) ||
            (mayBeOpen && splitter.split(bytes, from, end, Quotes.LITERAL) == wanted) ||
            (mayBeOpen && splitter.split(bytes, from, end, Quotes.LENIENT) == wanted)
        if (fits) {
            problems.add(
                ProblemKind.QUOTES_REPAIRED,
                "A cell has unescaped quotes; the row was split to match the number of titles.",
                line,
            )
        }
        return fits
    }

    /** Joins a text cell that a raw newline has split. The pieces belong together if they then have the right number of cells. */
    private fun joinedLines(bytes: ByteArray, from: Int, end: Int, next: Int, until: Int, isEnd: Boolean): Int {
        var start = next
        // Without quotes, counting commas gives the number of cells, so nothing has to be split repeatedly.
        var commas = bytes.count(COMMA, from, end)
        var quotes = bytes.count(QUOTE, from, end)
        for (lines in 2..MAX_LINES) {
            val pieceEnd = lineEndIn(bytes, start, until)
            if (pieceEnd - from > MAX_BYTES) return NO_MATCH
            if (pieceEnd == until && !isEnd) return RowScanner.INCOMPLETE
            if (start == until || (pieceEnd < until && bytes[pieceEnd].toInt() == NUL)) return NO_MATCH
            if (isCompleteRow(bytes, start, pieceEnd)) return NO_MATCH
            commas += bytes.count(COMMA, start, pieceEnd)
            quotes += bytes.count(QUOTE, start, pieceEnd)
            val isSplit = quotes > 0 || commas + 1 >= cells.columns
            val count = if (isSplit) splitter.split(bytes, from, pieceEnd, Quotes.LENIENT) else commas + 1
            if (isSplit && (count > cells.columns || splitter.isOpen)) return NO_MATCH
            val after = afterLineEnd(bytes, pieceEnd, until, isEnd)
            if (after == RowScanner.INCOMPLETE) return after
            if (count == cells.columns) {
                if (!isTextTornAt(bytes, end, next)) return NO_MATCH
                linesPassed = lines
                problems.add(
                    ProblemKind.LINES_JOINED,
                    "A newline in a text split the row into $lines lines; they were joined.",
                    line,
                )
                take(bytes, false, after)
                if (pieceEnd == until && endsInNewline) dropLastCell(bytes)
                return after
            }
            start = after
        }
        return NO_MATCH
    }

    /** Handles a piece of the last topic's text that a raw newline split off. It is a line of one text, where a number should be. */
    private fun continuesText(bytes: ByteArray, from: Int, end: Int, row: Int): Boolean {
        val isPiece = cells.columns > 1 && columns[0].firstText == null &&
            (from until end).none { bytes[it].toInt() == COMMA } &&
            !isEndOfRow(bytes, from, end) &&
            reader.read(bytes, from, end) == CellKind.TEXT &&
            columns.last().extendText(row, bytes, from, end, MAX_BYTES)
        if (isPiece) {
            problems.add(ProblemKind.LINES_JOINED, "A line of text was joined to the text in the row above it.", line)
        }
        return isPiece
    }

    /**
     * Returns whether the bytes are a number directly followed by letters. Such a line is a row that damage reduced to its x and its end.
     */
    private fun isEndOfRow(bytes: ByteArray, from: Int, end: Int): Boolean {
        var at = from
        while (at < end && bytes[at] in ZERO..NINE) at++
        if (at == from || at == end || bytes[at].toInt() != DOT) return false
        at++
        while (at < end && bytes[at] in ZERO..NINE) at++
        return at < end && isLetterOrDigit(bytes[at].toInt().toChar())
    }

    // Returns whether the newline is in a text. Two short rows of numbers could also be joined, but a newline is never inside a number.
    private fun isTextTornAt(bytes: ByteArray, newline: Int, next: Int): Boolean {
        for (i in 0 until cells.columns) {
            val start = splitter.starts[i]
            val end = splitter.ends[i]
            if (newline in start..end) {
                return reader.read(bytes, start, newline) == CellKind.TEXT ||
                    reader.read(bytes, minOf(next, end), lineEndIn(bytes, minOf(next, end), end)) == CellKind.TEXT
            }
        }
        return false
    }

    private fun isCompleteRow(bytes: ByteArray, from: Int, until: Int): Boolean = cells.columns > 1 &&
        splitter.split(bytes, from, until, Quotes.STRICT) == cells.columns &&
        !splitter.isOpen && !splitter.isMalformed

    /** Takes a row with too few or too many cells, which no reading could repair. */
    private fun takeUneven(bytes: ByteArray, from: Int, end: Int, next: Int): Int {
        var count = splitter.split(bytes, from, end, Quotes.STRICT)
        val isStrict = !splitter.isOpen && !splitter.isMalformed
        if (!isStrict) count = splitter.split(bytes, from, end, Quotes.LENIENT)
        val wanted = cells.columns
        if (count < wanted) {
            problems.add(ProblemKind.ROW_SHORT, "A row has $count of $wanted cells; the missing ones were left empty.", line)
        } else {
            val extra = quotation(bytes, splitter.starts[wanted], end)
            problems.add(
                ProblemKind.ROW_LONG,
                "A row has $count cells instead of $wanted; the extra ones were dropped: $extra.",
                line,
                loss = Loss(cells = count - wanted, bytes = (end - splitter.starts[wanted]).toLong()),
            )
        }
        return take(bytes, isStrict, next, count)
    }

    /** Drops the bytes between a hole and the next newline, as they would be a complete row only by chance. */
    private fun dropFragment(bytes: ByteArray, from: Int, end: Int, next: Int): Int {
        problems.add(
            ProblemKind.ROW_CUT,
            "The end of a row whose beginning is lost was dropped; it held ${quotation(bytes, from, end)}.",
            line,
            loss = Loss(rows = 1, cells = splitter.split(bytes, from, end, Quotes.STRICT), bytes = (end - from).toLong()),
        )
        return next
    }

    private fun hole(bytes: ByteArray, from: Int, nul: Int): Int {
        if (nul > from) tail(bytes, from, nul, true)
        linesPassed = 0
        return nul
    }

    /**
     * Reads a row without a newline, at the end of the file or before a hole.
     *
     * @param isCut whether a missing newline means that bytes are missing.
     */
    private fun tail(bytes: ByteArray, from: Int, until: Int, isCut: Boolean): Int {
        linesPassed = 1
        val wanted = cells.columns
        val count = splitter.split(bytes, from, until, Quotes.STRICT)
        val isStrict = !splitter.isMalformed
        if (!isStrict && readWithOddQuotes(bytes, from, until, mayBeOpen = false)) {
            take(bytes, false, until)
            if (isCut) dropLastCell(bytes)
            return until
        }
        if (splitter.isOpen || count < wanted) {
            problems.add(
                ProblemKind.ROW_CUT,
                "A row is cut off after $count of $wanted cells and was dropped; " +
                    "it held ${quotation(bytes, from, until)}.",
                line,
                loss = Loss(rows = 1, cells = count, bytes = (until - from).toLong()),
            )
            return until
        }
        if (!isStrict || count > wanted) return takeUneven(bytes, from, until, until)
        take(bytes, true, until)
        if (isCut) dropLastCell(bytes)
        return until
    }

    private fun dropLastCell(bytes: ByteArray) {
        val last = cells.columns - 1
        cells.kinds[last] = CellKind.EMPTY
        cells.numbers[last] = Double.NaN
        val held = quotation(bytes, splitter.starts[last], splitter.ends[last])
        problems.add(
            ProblemKind.LAST_CELL_CUT,
            "The last row lacks its newline, so its last cell may be cut and was left empty; it held $held.",
            line,
            columns[last].name,
            loss = Loss(cells = 1, bytes = (splitter.ends[last] - splitter.starts[last]).toLong()),
        )
    }

    private fun take(bytes: ByteArray, undouble: Boolean, next: Int, count: Int = cells.columns): Int {
        copy.take(bytes, undouble, count)
        hasRow = true
        return next
    }

    private fun quotation(bytes: ByteArray, from: Int, until: Int): String = "“${decoder.excerpt(bytes, from, until, QUOTED_BYTES)}”"

    private fun ByteArray.count(byte: Int, from: Int, until: Int): Int {
        var count = 0
        for (i in from until until) if (this[i].toInt() == byte) count++
        return count
    }
}

private const val NO_MATCH = -3

// For a damaged row the parser may look ahead, but never hold more than this.
private const val MAX_LINES = 100
private const val MAX_BYTES = 1 shl 16
private const val QUOTED_BYTES = 200
