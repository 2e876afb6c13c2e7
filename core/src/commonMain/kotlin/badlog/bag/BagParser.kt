package badlog.bag

import badlog.recording.ProblemKind
import badlog.recording.ProblemList
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic

/**
 * Reads a bag, or a plain CSV file, that is pushed to it in pieces of any size. Nothing in the bytes makes it throw:
 * whatever is wrong becomes a problem of the recording, by the rules in `docs/bag-format.md`.
 *
 * Besides the recording's own columns it holds one piece of the file, never the file. Compressed files are to be inflated
 * before. Not safe for use by several threads.
 *
 * @param expectedBytes how long the file will be, if known: spares columns from growing. 0 when it is not known.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 */
public class BagParser(
    private val expectedBytes: Long = 0,
    private val keepSamples: Boolean = true,
) {
    private enum class Stage { START, FIRST_LINE, TITLES, ROWS, IGNORING }

    private val decoder = TextDecoder()
    private val problems = ProblemList()
    private var stage = Stage.START

    // What has arrived and is not read yet stands in buffer[start, end).
    private var buffer = ByteArray(2 * PIECE)
    private var start = 0
    private var end = 0
    private var waitsForLineEnd = false

    private var line = 1
    private var isInHole = false
    private var holeBytes = 0
    private var sawCarriageReturn = false
    private var headerLine: String? = null
    private var header: BagHeader? = null
    private var layout: HeaderColumns? = null
    private var table: Table? = null

    /** How many rows have been read so far. */
    public var rowCount: Int = 0
        private set

    /** The reader of rows, there as soon as the columns are known. */
    private class Table(
        val columns: Array<ColumnBuilder>,
        val cells: RowCells,
        val scanner: RowScanner,
        val repair: RowRepair,
        val firstByte: Int,
    )

    /** Reads the bytes from [from] until [until] of [bytes], which follow those of the calls before. Keeps no reference. */
    public fun accept(bytes: ByteArray, from: Int = 0, until: Int = bytes.size) {
        var at = from
        while (at < until && stage != Stage.IGNORING) {
            val size = minOf(PIECE, until - at)
            append(bytes, at, at + size)
            at += size
            if (!waitsForLineEnd || holdsLineEnd(bytes, at - size, at)) advance(false)
        }
    }

    /** Says that the file has ended, and returns what was read. To be called once, last. */
    public fun finish(): Recording {
        advance(true)
        return build()
    }

    private fun append(bytes: ByteArray, from: Int, until: Int) {
        if (end + until - from > buffer.size) {
            buffer.copyInto(buffer, 0, start, end)
            end -= start
            start = 0
            if (end + until - from > buffer.size) buffer = buffer.copyOf((end + until - from) * 2)
        }
        bytes.copyInto(buffer, end, from, until)
        end += until - from
    }

    private fun holdsLineEnd(bytes: ByteArray, from: Int, until: Int): Boolean {
        for (i in from until until) if (isLineEnd(bytes[i].toInt())) return true
        return end - start > LONGEST_WAIT
    }

    private fun isLineEnd(byte: Int) = byte == LF || byte == CR || byte == NUL

    private fun advance(isEnd: Boolean) {
        if (isInHole) passNuls(isEnd)
        while (start < end) {
            val next = when (stage) {
                Stage.START -> readSignature(isEnd)
                Stage.FIRST_LINE -> readFirstLine(isEnd)
                Stage.TITLES -> readTitles(isEnd)
                Stage.ROWS -> readRow(isEnd)
                Stage.IGNORING -> end
            }
            waitsForLineEnd = next == RowScanner.INCOMPLETE
            if (waitsForLineEnd) return
            start = next
            if (isInHole) passNuls(isEnd)
        }
    }

    private fun readSignature(isEnd: Boolean): Int {
        if (end - start < FileSignature.BYTES && !isEnd) return RowScanner.INCOMPLETE
        when (FileSignature.of(buffer.copyOfRange(start, minOf(end, start + FileSignature.BYTES)))) {
            FileSignature.GZIP -> return ignore("The file is compressed with gzip and has to be inflated first.")
            FileSignature.WPILOG -> return ignore("This is a WPILOG file; this version of badlog reads bags and CSV.")
            FileSignature.OTHER -> stage = Stage.FIRST_LINE
        }
        return if (end - start >= 3 && BYTE_ORDER_MARK.indices.all { buffer[start + it] == BYTE_ORDER_MARK[it] }) {
            problems.add(ProblemKind.BYTE_ORDER_MARK, "The file begins with a byte order mark, which was skipped.", 1)
            start + BYTE_ORDER_MARK.size
        } else {
            start
        }
    }

    private fun readFirstLine(isEnd: Boolean): Int {
        val lineEnd = findLineEnd(isEnd)
        if (lineEnd < 0) return lineEnd
        if (isBinary(start, lineEnd)) return ignore(BINARY)
        if (lineEnd == start && lineEnd < end) return skipBlankLine(lineEnd, isEnd)
        if (buffer[start].toInt() != BRACE) {
            stage = Stage.TITLES
            return start
        }
        val next = afterLineEnd(lineEnd, isEnd)
        if (next == RowScanner.INCOMPLETE) return next
        val text = decodeHeader(start, lineEnd)
        headerLine = text
        header = readHeader(text)
        if (header == null) {
            problems.add(
                ProblemKind.HEADER_UNREADABLE,
                "Line 1 is cut or is not JSON, so units, attributes and values are lost; the rest was read as CSV.",
                line,
            )
        }
        stage = Stage.TITLES
        if (lineEnd < end) line++
        return next
    }

    private fun readTitles(isEnd: Boolean): Int {
        val lineEnd = findLineEnd(isEnd)
        if (lineEnd < 0) return lineEnd
        if (isBinary(start, lineEnd)) return ignore(BINARY)
        val next = afterLineEnd(lineEnd, isEnd)
        if (next == RowScanner.INCOMPLETE) return next
        if (lineEnd == start && lineEnd < end) return skipBlankLine(lineEnd, isEnd)
        // A header whose titles line is cut off knows its topics better than that line does.
        val isCut = lineEnd == end || buffer[lineEnd].toInt() == NUL
        if (!isCut || header == null) openTable(titlesIn(start, lineEnd), next)
        if (!isCut) line++
        stage = Stage.ROWS
        return next
    }

    private fun skipBlankLine(lineEnd: Int, isEnd: Boolean): Int {
        val next = afterLineEnd(lineEnd, isEnd)
        if (next > lineEnd) {
            problems.add(ProblemKind.BLANK_LINE, "A blank line was skipped.", line)
            line++
        }
        return next
    }

    private fun openTable(titles: List<String>, firstByte: Int) {
        val columns = HeaderColumns.match(header, titles, line, problems)
        val builders = Array(titles.size) { index ->
            val isLog = columns.topics[index]?.attributes?.contains("log") == true
            ColumnBuilder(columns.columnNames[index], !isLog, keepSamples, decoder)
        }
        val cells = RowCells(titles.size)
        val reader = CellReader()
        val repair = RowRepair(cells, reader, builders, decoder, problems, endsInNewline = headerLine != null)
        layout = columns
        table = Table(builders, cells, RowScanner(cells, reader), repair, firstByte)
    }

    private fun titlesIn(from: Int, until: Int): List<String> {
        // The original does not quote names, so a name with a comma is told only by the header.
        val names = header?.topics?.map { it.name }
        val text = decodeHeader(from, until)
        if (names != null && names.size > 1 && text == names.joinToString(",")) return names
        val splitter = RowSplitter()
        val count = splitter.split(buffer, from, until, RowSplitter.Quotes.STRICT)
        return List(count) { index ->
            val title = decoder.decode(buffer, splitter.starts[index], splitter.ends[index])
            if (splitter.quoted[index]) title.replace("\"\"", "\"") else title.trim()
        }
    }

    private fun readRow(isEnd: Boolean): Int {
        val table = table ?: return end
        val scanned = table.scanner.scan(buffer, start, end)
        if (scanned >= 0) {
            if (table.scanner.endedInCarriageReturn) sawCarriageReturn = true
            table.cells.commit(table.columns, rowCount, buffer, line)
            line++
            countRow(table)
            return scanned
        }
        if (scanned == RowScanner.INCOMPLETE && !isEnd && end - start < LONGEST_WAIT) return scanned
        val repair = table.repair
        val next = repair.repair(buffer, start, end, isEnd, line)
        if (next == RowScanner.INCOMPLETE) return if (end - start < LONGEST_LINE) next else giveUp()
        if (repair.hasRow) {
            table.cells.commit(table.columns, rowCount, repair.text, line)
            countRow(table)
        }
        line += repair.linesPassed
        if (repair.isAtHole) beginHole()
        if (next > start && buffer[next - 1].toInt() == CR) sawCarriageReturn = true
        return next
    }

    private fun countRow(table: Table) {
        rowCount++
        if (rowCount == SAMPLE_ROWS && expectedBytes > 0) {
            val bytesPerRow = maxOf(1, (start - table.firstByte) / SAMPLE_ROWS)
            val rows = minOf(expectedBytes / bytesPerRow + expectedBytes / bytesPerRow / 64, MOST_EXPECTED_ROWS)
            for (column in table.columns) column.expect(rows.toInt())
        }
    }

    /** The end of the line at [start]; at the end of the file its end; INCOMPLETE when it is not in sight. */
    private fun findLineEnd(isEnd: Boolean): Int {
        for (i in start until end) if (isLineEnd(buffer[i].toInt())) return i
        return when {
            isEnd -> end
            end - start > LONGEST_LINE || isBinary(start, end) -> ignore(BINARY).let { RowScanner.INCOMPLETE }
            else -> RowScanner.INCOMPLETE
        }
    }

    private fun afterLineEnd(lineEnd: Int, isEnd: Boolean): Int {
        if (lineEnd == end) return end
        val byte = buffer[lineEnd].toInt()
        if (byte == NUL) {
            beginHole()
            return lineEnd
        }
        if (byte == LF) return lineEnd + 1
        if (lineEnd + 1 == end && !isEnd) return RowScanner.INCOMPLETE
        sawCarriageReturn = true
        return if (lineEnd + 1 < end && buffer[lineEnd + 1].toInt() == LF) lineEnd + 2 else lineEnd + 1
    }

    private fun beginHole() {
        isInHole = true
        holeBytes = 0
    }

    /** Skips the NULs at [start]; says how many there were when they are over. */
    private fun passNuls(isEnd: Boolean) {
        while (start < end && buffer[start].toInt() == NUL) {
            start++
            holeBytes++
        }
        if (start == end && !isEnd) return
        problems.add(
            ProblemKind.NUL_HOLE,
            "$holeBytes NUL bytes stand where data should be, as after a loss of power; what was there is lost.",
            line,
        )
        isInHole = false
    }

    private fun decodeHeader(from: Int, until: Int): String {
        val text = decoder.decode(buffer, from, until)
        if (decoder.wasNotUtf8) {
            problems.add(
                ProblemKind.NOT_UTF8,
                "The header is not UTF-8; it was read as Windows-1252.",
                line,
            )
        }
        return text
    }

    private fun isBinary(from: Int, until: Int): Boolean {
        for (i in from until until) if (buffer[i] in CONTROLS && buffer[i].toInt() != TAB) return true
        return false
    }

    private fun giveUp(): Int {
        problems.add(
            ProblemKind.ROW_CUT,
            "A line of more than $LONGEST_LINE bytes is no row of samples; what follows was not read.",
            line,
        )
        return ignoreRest()
    }

    private fun ignore(message: String): Int {
        problems.add(ProblemKind.NOT_A_RECORDING, message, line)
        return ignoreRest()
    }

    private fun ignoreRest(): Int {
        stage = Stage.IGNORING
        start = end
        return end
    }

    private fun build(): Recording {
        val topics = topics()
        if (sawCarriageReturn) {
            problems.add(ProblemKind.CARRIAGE_RETURNS, "Lines end in a carriage return, as on Windows; that is fine.")
        }
        reportEmptiness(topics)
        return Recording(
            format = if (headerLine != null) RecordingFormat.BAG else RecordingFormat.CSV,
            headerLine = headerLine,
            values = header?.values.orEmpty().map { it.value },
            topics = topics,
            rowCount = rowCount,
            problems = problems.toList(),
        )
    }

    private fun topics(): List<Topic> {
        val table = table
        val layout = layout
        if (table == null || layout == null) {
            val titles = header?.topics.orEmpty().map { it.name }
            if (titles.isEmpty()) return emptyList()
            openTable(titles, 0)
            return topics()
        }
        return layout.order.map { index ->
            val described = layout.topics[index]
            val column = table.columns[index]
            val topic = column.build(rowCount, described?.unit ?: Topic.UNITLESS, described?.attributes.orEmpty())
            reportColumn(column, topic, problems)
            topic
        }
    }

    private fun reportEmptiness(topics: List<Topic>) {
        val isLoneText = header == null && topics.size == 1 && rowCount > 0 && topics[0].counts.run { texts == total }
        when {
            stage == Stage.IGNORING -> return
            headerLine == null && topics.isEmpty() ->
                problems.add(ProblemKind.EMPTY_FILE, "The file is empty; the robot may have been switched off too early.")
            isLoneText -> problems.add(ProblemKind.NOT_A_RECORDING, "$NO_LOG: it is a text without columns.", 1)
            rowCount == 0 -> problems.add(
                ProblemKind.NO_ROWS,
                "There is a header but not one row of samples; the robot may have been switched off too early.",
                line,
            )
        }
    }

    private companion object {
        /** How much is read at a time: enough to be fast, little enough to stay in the processor's cache. */
        const val PIECE = 1 shl 16

        /** No header line is longer; a file without a newline before is not a bag. */
        const val LONGEST_LINE = 1 shl 24
        const val LONGEST_WAIT = 1 shl 20

        /** So many rows are looked at to guess how many there will be. */
        const val SAMPLE_ROWS = 64
        const val MOST_EXPECTED_ROWS = 1L shl 24

        val BYTE_ORDER_MARK = byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte())
        val CONTROLS = 1.toByte()..31.toByte()
        const val NO_LOG = "This file is neither a bag, nor a CSV file, nor a WPILOG"
        const val BINARY = "$NO_LOG: it holds bytes that no text has."
    }
}
