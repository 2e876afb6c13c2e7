package badlog.lib

import badlog.bag.RowWriter
import java.io.IOException

/**
 * Takes rows and writes them: each at once, or several together, but none later than a quarter of a second after the
 * write before. Rows that cannot be written are lost and counted; it then waits a little before it tries again, because
 * a disk that is full or gone may be slow to say so. Guarded by the log's lock.
 */
internal class RowSink(
    private val file: LogFile,
    private val flushesEachRow: Boolean,
    private val faults: Faults,
) {
    private val output = file.output
    private val counters = faults.counters
    private var header: ByteArray? = null
    private var rowsWaiting = 0
    private var lastWrite = System.nanoTime()
    private var rowsLost = 0L

    /** Where the next row's cells are to be written. */
    val row = RowWriter()

    /** Whether the last try to write failed. */
    @Volatile
    var isFailing: Boolean = false
        private set

    /** Whether something was written since this was last set to false. */
    @Volatile
    var isDirty: Boolean = false

    /** Writes [lines] before any row. */
    fun begin(lines: ByteArray) {
        header = lines
        write(System.nanoTime())
    }

    /** Ends the row in [row], whose writing began at [began] of [System.nanoTime]. */
    fun endRow(began: Long) {
        row.endRow()
        rowsWaiting++
        if (flushesEachRow || row.size >= BATCH_BYTES || began - lastWrite >= LONGEST_WAIT_NANOS) {
            if (isFailing && began - lastWrite < RETRY_NANOS) drop() else write(began)
        }
        counters.rowTook(System.nanoTime() - began)
    }

    /** Forgets the row that was begun. */
    fun dropRow() {
        row.dropRow()
        counters.rowsMissed.incrementAndGet()
    }

    /** Writes all rows that wait. */
    fun flush() {
        if (rowsWaiting > 0 || header != null) write(System.nanoTime())
    }

    /** Writes what waits and what the end of the file needs. */
    fun finish() {
        flush()
        try {
            output.finish()
            isDirty = true
        } catch (failure: IOException) {
            sayFailed(failure)
        }
    }

    private fun write(now: Long) {
        lastWrite = now
        try {
            header?.let {
                output.append(it, it.size)
                header = null
            }
            val began = System.nanoTime()
            if (rowsWaiting > 0) output.append(row.bytes, row.size)
            counters.wrote(rowsWaiting, output.length, System.nanoTime() - began)
            isDirty = true
            row.clear()
            rowsWaiting = 0
            if (isFailing) recovered()
        } catch (failure: IOException) {
            drop()
            isFailing = true
            sayFailed(failure)
        }
    }

    private fun sayFailed(failure: IOException) = faults.sayOnce(
        "write",
        "The log ${file.path} cannot be written: ${describe(failure)}. Rows are lost until it can; see whether " +
            "the disk is full, or was pulled out.",
    )

    private fun drop() {
        rowsLost += rowsWaiting
        counters.rowsMissed.addAndGet(rowsWaiting.toLong())
        row.clear()
        rowsWaiting = 0
    }

    private fun recovered() {
        isFailing = false
        faults.room?.note("$rowsLost rows before this one could not be written")
        rowsLost = 0
    }

    private companion object {
        // What RandomAccessFile.write takes without making a buffer, less a long row.
        const val BATCH_BYTES = 6 * 1024
        const val LONGEST_WAIT_NANOS = 250_000_000L
        const val RETRY_NANOS = 250_000_000L
    }
}
