package badlog.core.bag

import badlog.core.recording.ProblemList
import badlog.core.text.LF
import badlog.core.text.TextDecoder

/**
 * Reads some of a bag's rows independently of those before them, so that several parsers can share a file. Reusable, but not by several
 * threads at a time.
 *
 * @param readsDecimalComma see [BagParser.readsDecimalComma].
 * @param keepSamples as for the [BagParser].
 */
public class RowBatchParser(readsDecimalComma: BooleanArray, private val keepSamples: Boolean = true) {
    private val decoder = TextDecoder()
    private val pending = PendingBytes(room = 0)
    private val columns = Array(readsDecimalComma.size) { ColumnBuilder("", readsDecimalComma[it], keepSamples, decoder) }
    private val cells = RowCells(columns.size)
    private val cellReader = CellReader()
    private val scanner = RowScanner(cells, cellReader)

    /**
     * Reads the rows of [bytes] from [from], where a row begins, until [until], which follows the newline of a row.
     *
     * @return the rows; the next call overwrites their numbers. Null if something is irregular: the rows may then depend on those before or
     *   after, and the [BagParser] must read the bytes itself.
     */
    public fun parse(bytes: ByteArray, from: Int, until: Int): RowBatch? {
        if (until <= from || bytes[until - 1].toInt() != LF) return null
        val problems = ProblemList()
        val repair = RowRepair(pending, cells, cellReader, columns, decoder, problems, endsInNewline = true)
        for (column in columns) column.clear()
        pending.lend(bytes, from, until)
        var rows = 0
        while (pending.size > 0) {
            if (rows == SAMPLE_ROWS) makeRoom(rows, pending.start - from, until - from)
            var next = scanner.scan(bytes, pending.start, until)
            var lines = 1
            if (next >= 0) {
                cells.commit(columns, rows, bytes, pending.line)
            } else {
                next = repair.repair(false, rows)
                if (!repair.hasRow || !problems.isEmpty) return null
                cells.commit(columns, rows, repair.text, pending.line)
                lines = repair.linesPassed
            }
            rows++
            pending.line += lines
            pending.advanceTo(next)
        }
        if (columns.any { it.notUtf8Line > 0 }) return null
        return batch(rows, until - from)
    }

    private fun makeRoom(rows: Int, bytes: Int, allBytes: Int) {
        val likely = (rows * (allBytes.toDouble() / bytes) * SPARE).toInt() + 1
        for (column in columns) column.expect(likely)
    }

    private fun batch(rows: Int, bytes: Int): RowBatch {
        val out = BatchWriter()
        out.put(rows)
        out.put(pending.line - 1)
        out.put(bytes)
        out.put(if (pending.sawCarriageReturn) 1 else 0)
        return out.batch(Array(columns.size) { columns[it].writeTo(out) })
    }
}

private const val SAMPLE_ROWS = 64
private const val SPARE = 1 + 1.0 / 16
