package badlog.lib

import badlog.core.bag.RowWriter
import java.io.IOException

/**
 * Writes rows: each at once, or several together at most a quarter of a second after the previous write. Rows that cannot be written are
 * lost and counted. After a failure it waits before the next attempt, because a full or missing disk may be slow to report it. Guarded by
 * the log's lock.
 */
internal class RowSink(
    private val file: LogFile,
    private val flushesEachRow: Boolean,
    private val faults: Faults,
    private val time: LogTime,
) {
    private val output = file.output
    private val counters = faults.counters
    private var events = emptyArray<EventTexts>()
    private var header: ByteArray? = null
    private var rowsWaiting = 0
    private var lastWrite = time.now
    private var rowsLost = 0L

    /** The writer for the next row's cells. */
    val row = RowWriter()

    /** Whether the last attempt to write failed. */
    @Volatile
    var isFailing: Boolean = false
        private set

    /** Whether something was written since this was last set to false. */
    @Volatile
    var isDirty: Boolean = false

    /** Writes [lines] ahead of all rows. [events] holds the texts that later rows will contain. */
    fun begin(lines: ByteArray, events: Array<EventTexts>) {
        this.events = events
        header = lines
        write(time.now)
    }

    /** Returns whether a row begun at [now] would be lost. Do not begin it then, so that no events are lost with it. */
    fun isRefusing(now: Long): Boolean = isWaitingToRetry(now) && (flushesEachRow || row.size >= BATCH_BYTES)

    /** Counts a row that was not begun. */
    fun missRow() = lose(1)

    /** Ends the row in [row], which was begun at [began], a time of [LogTime.now]. */
    fun endRow(began: Long) {
        row.endRow()
        rowsWaiting++
        val isDue = flushesEachRow || row.size >= BATCH_BYTES || began - lastWrite >= MAX_WAIT_NANOS
        if (isDue && !isWaitingToRetry(began)) write(began)
        counters.addRowTime(time.now - began)
    }

    /** Discards the row that was begun. */
    fun dropRow() {
        row.dropRow()
        counters.rowsMissed.incrementAndGet()
        // This includes the events of buffered rows: an event in two rows is better than in none.
        for (texts in events) texts.restore()
    }

    /** Writes all buffered rows. */
    fun flush() {
        if (rowsWaiting > 0 || header != null) write(time.now)
    }

    /** Does the same as [flush], unless a write has just failed. */
    fun flushWaiting() {
        if (!isWaitingToRetry(time.now)) flush()
    }

    /** Writes the buffered rows and the end of the file. */
    fun finish() {
        flush()
        try {
            timed { output.finish() }
            isDirty = true
        } catch (failure: IOException) {
            reportFailed(failure)
        }
        for (texts in events) texts.end()
    }

    private fun isWaitingToRetry(now: Long) = isFailing && now - lastWrite < RETRY_NANOS

    private fun write(now: Long) {
        lastWrite = now
        try {
            header?.let {
                timed { output.append(it, it.size) }
                header = null
            }
            if (rowsWaiting > 0) timed { output.append(row.bytes, row.size) }
            // Writing to a deleted file succeeds silently; a file that was only moved may come back.
            if (file.isMissing) counters.rowsMissed.addAndGet(rowsWaiting.toLong()) else counters.addWrittenRows(rowsWaiting)
            counters.setFileLength(output.length)
            isDirty = true
            forgetRows()
            for (texts in events) texts.written()
            if (isFailing) recovered()
        } catch (failure: IOException) {
            lose(rowsWaiting)
            forgetRows()
            for (texts in events) texts.restore()
            isFailing = true
            reportFailed(failure)
        }
    }

    /** In `finally`, because a failing disk is usually a slow one. */
    private inline fun timed(write: () -> Unit) {
        val began = time.now
        try {
            write()
        } finally {
            counters.addWriteTime(time.now - began)
        }
    }

    private fun reportFailed(failure: IOException) = faults.reportOnce("write") {
        "The log ${file.path} cannot be written: ${describe(failure)}. Rows are lost until it can; check whether " +
            "the disk is full or was removed."
    }

    private fun lose(rows: Int) {
        rowsLost += rows
        counters.rowsMissed.addAndGet(rows.toLong())
    }

    private fun forgetRows() {
        row.clear()
        rowsWaiting = 0
    }

    private fun recovered() {
        isFailing = false
        faults.note("$rowsLost rows before this one could not be written")
        rowsLost = 0
    }
}

// The bytes that RandomAccessFile.write accepts without allocating a buffer, minus a long row.
private const val BATCH_BYTES = 6 * 1024
private const val MAX_WAIT_NANOS = 250_000_000L
private const val RETRY_NANOS = 250_000_000L
