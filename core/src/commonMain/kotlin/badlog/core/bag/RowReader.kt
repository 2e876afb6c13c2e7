package badlog.core.bag

import badlog.core.analysis.Units
import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.Topic
import badlog.core.text.TextDecoder
import badlog.core.text.originOf

/** Reads the rows into columns: plain ones with [RowScanner], all others with [RowRepair]. */
internal class RowReader(
    private val pending: PendingBytes,
    private val layout: HeaderColumns,
    private val decoder: TextDecoder,
    private val problems: ProblemList,
    private val keepSamples: Boolean,
    sinks: NumberSinks,
    endsInNewline: Boolean,
    private val expectedBytes: Long,
    private val expectedLines: Long,
    private val maxRows: Int,
    private val forAll: (count: Int, work: (Int) -> Unit) -> Unit,
) {
    private val columns = Array(layout.columnNames.size) { index ->
        val name = layout.columnNames[index]
        val attributes = layout.topics[index]?.attributes.orEmpty()
        ColumnBuilder(name, "log" !in attributes, keepSamples, decoder, sinks.of(name, attributes))
    }
    private val cells = RowCells(columns.size)
    private val cellReader = CellReader()
    private val scanner = RowScanner(cells, cellReader)
    private val repair = RowRepair(pending, cells, cellReader, columns, decoder, problems, endsInNewline)
    private val passedBefore = pending.passed

    // The columns have room for this many rows.
    private var roomyRows = SAMPLE_ROWS

    /** The index of the column with the x axis; -1 if there is none. */
    val axis = layout.topics.indexOfFirst { "xaxis" in it?.attributes.orEmpty() }
    private val microsPerX = if (axis < 0) 0.0 else Units.microsIn(layout.topics[axis]?.unit.orEmpty())

    /** The first x, in µs, if it is a time since 1970; otherwise 0. NaN if there is none. */
    var origin = Double.NaN
        private set

    /** The number of rows read. */
    var rowCount = 0
        private set

    /** Whether reading stopped because the bytes that follow are not rows at all. */
    var hasGivenUp = false
        private set

    /** Reads one row. Returns where the next begins, or [RowScanner.INCOMPLETE]. */
    fun read(isEnd: Boolean): Int {
        if (rowCount >= maxRows) return giveUp(ProblemKind.TOO_MANY_ROWS, tooMany())
        val hasEnd = pending.start < pending.lineEnd
        val scanned = if (hasEnd) scanner.scan(pending.bytes, pending.start, pending.end) else RowScanner.INCOMPLETE
        if (scanned >= 0) {
            addRow(pending.bytes)
            pending.line++
            return scanned
        }
        if (scanned == RowScanner.INCOMPLETE && !isEnd && pending.size < MAX_SCAN_BYTES) return scanned
        val next = repair.repair(isEnd, rowCount)
        if (next == RowScanner.INCOMPLETE) return if (pending.size < MAX_ROW_BYTES) next else giveUp(ProblemKind.ROW_CUT, TOO_LONG)
        if (repair.hasRow) addRow(repair.text)
        pending.line += repair.linesPassed
        return next
    }

    /** For each column, whether it has numbers, in which a decimal comma is read, rather than texts. */
    val readsDecimalComma: BooleanArray get() = BooleanArray(columns.size) { columns[it].readsDecimalComma }

    /** Adds rows that a [RowBatchParser] read. Returns false if they lack numbers that are needed here. */
    fun add(batch: RowBatch): Boolean {
        if (batch.rowCount > maxRows - rowCount) return false
        if (batch.hasSamples != keepSamples || (!keepSamples && columns.any { it.hasSink })) return false
        // The first x may be in it.
        if (axis >= 0 && origin.isNaN() && !keepSamples) return false
        val linesBefore = pending.line - 1
        pending.pass(batch)
        if (rowCount + batch.rowCount > roomyRows) makeRoom(rowCount + batch.rowCount)
        if (axis >= 0 && keepSamples) for (row in 0 until batch.rowCount) countFromOrigin(batch.numbers[axis], row)
        val details = BatchReader(batch, BatchReader.COMMON_INTS)
        for (i in columns.indices) columns[i].append(rowCount, batch.rowCount, batch.numbers[i], details, linesBefore)
        rowCount += batch.rowCount
        return true
    }

    private fun addRow(text: ByteArray) {
        if (rowCount == roomyRows) makeRoom(rowCount)
        if (axis >= 0 && cells.kinds[axis].let { it != CellKind.EMPTY && it != CellKind.TEXT }) countFromOrigin(cells.numbers, axis)
        cells.commit(columns, rowCount, text, pending.line)
        rowCount++
    }

    /** Makes the x at [index] of [numbers] seconds since the first one, if that is a time since 1970. */
    private fun countFromOrigin(numbers: DoubleArray, index: Int) {
        val micros = numbers[index] * microsPerX
        if (origin.isNaN()) origin = if (micros.isFinite()) originOf(micros) else return
        if (origin > 0) numbers[index] = (micros - origin) / 1e6
    }

    /**
     * Reserves memory for the rows that the file is likely to have. The first rows of a log are seldom like the others,
     * so the estimate is trusted only up to a multiple of the rows it was made from, and repeated when that is reached.
     */
    private fun makeRoom(rows: Int) {
        val passed = pending.passed - passedBefore
        if (passed >= expectedBytes) return
        val likely = (rows * (expectedBytes.toDouble() / passed) * SPARE).toLong() + 1
        val counted = rows + expectedLines - (pending.line - 1)
        // Lines may be empty, so their number is trusted only if it fits their length.
        val room = if (counted in rows..2 * likely) counted else minOf(likely, rows * MAX_GROWTH)
        roomyRows = minOf(room, maxRows.toLong()).toInt()
        forAll(columns.size) { columns[it].expect(roomyRows) }
    }

    private fun tooMany() = "The log has more than $maxRows rows; the rest was not read."

    private fun giveUp(kind: ProblemKind, message: String): Int {
        hasGivenUp = true
        problems.add(kind, message, pending.line)
        return pending.end
    }

    /** Returns the topics made of all rows, in display order. Call it once, last. */
    fun topics(): List<Topic> {
        val topics = arrayOfNulls<Topic>(columns.size)
        forAll(columns.size) { index ->
            val described = layout.topics[index]
            val unit = if (index == axis && origin > 0) "s" else described?.unit ?: Topic.UNITLESS
            topics[index] = columns[index].build(rowCount, unit, described?.attributes.orEmpty())
        }
        return layout.order.map { index -> checkNotNull(topics[index]).also { reportColumn(columns[index], it, problems) } }
    }
}

private const val MAX_SCAN_BYTES = 1 shl 20
private const val MAX_ROW_BYTES = 1 shl 24
private const val TOO_LONG = "A line of more than $MAX_ROW_BYTES bytes is not a row of samples; the rest of the file was not read."

/** The number of rows after which the total is first estimated. */
private const val SAMPLE_ROWS = 64
private const val MAX_GROWTH = 16L

/** Allows for later rows being a little shorter than earlier ones. */
private const val SPARE = 1 + 1.0 / 64
