package badlog.lib

import java.util.concurrent.atomic.AtomicLong

/**
 * The numbers of rows, cells and calls that a log has written, lost or ignored since [BadLog.init], at one moment.
 *
 * @property rowsWritten rows that were passed to the operating system, except those written to a file known to be
 * deleted.
 * @property rowsMissed rows that were lost because they could not be written, or because the file was deleted,
 *   which is noticed after at most half a second.
 * @property bytesWritten the length of the file in bytes.
 * @property slowestRowNanos the duration of the slowest call of [BadLog.log], in nanoseconds.
 * @property slowWrites writes that took more than 5 ms, including failed ones.
 * @property failedSyncs the number of times that the operating system could not sync the file to the disk.
 * @property cellsMissed cells left empty because a supplier threw or returned null.
 * @property callsIgnored calls that were ignored, such as publishing to a name that was never created.
 * @property eventsDropped events that are in no row, because they came faster than rows, or the log ended before one could be written.
 */
public class LogCounters internal constructor(
    public val rowsWritten: Long,
    public val rowsMissed: Long,
    public val bytesWritten: Long,
    public val slowestRowNanos: Long,
    public val slowWrites: Long,
    public val failedSyncs: Long,
    public val cellsMissed: Long,
    public val callsIgnored: Long,
    public val eventsDropped: Long,
) {
    override fun toString(): String =
        "$rowsWritten rows written, $rowsMissed missed; $bytesWritten bytes; slowest row $slowestRowNanos ns; " +
            "$slowWrites slow writes, $failedSyncs failed syncs; $cellsMissed cells missed; " +
            "$callsIgnored calls ignored; $eventsDropped events dropped"
}

/** The live counters. Atomic because any thread may read them, and on a robot's CPU a plain long is not read in one step. */
internal class Counters {
    private val rowsWritten = AtomicLong()
    private val bytesWritten = AtomicLong()
    private val slowestRow = AtomicLong()
    private val slowWrites = AtomicLong()
    val rowsMissed = AtomicLong()
    val failedSyncs = AtomicLong()
    val cellsMissed = AtomicLong()
    val callsIgnored = AtomicLong()
    val eventsDropped = AtomicLong()

    fun addRowTime(nanos: Long) {
        if (nanos > slowestRow.get()) slowestRow.set(nanos)
    }

    fun addWriteTime(nanos: Long) {
        if (nanos > SLOW_NANOS) slowWrites.incrementAndGet()
    }

    fun addWrittenRows(rows: Int) {
        rowsWritten.addAndGet(rows.toLong())
    }

    fun setFileLength(fileLength: Long) = bytesWritten.set(fileLength)

    fun snapshot(): LogCounters = LogCounters(
        rowsWritten = rowsWritten.get(),
        rowsMissed = rowsMissed.get(),
        bytesWritten = bytesWritten.get(),
        slowestRowNanos = slowestRow.get(),
        slowWrites = slowWrites.get(),
        failedSyncs = failedSyncs.get(),
        cellsMissed = cellsMissed.get(),
        callsIgnored = callsIgnored.get(),
        eventsDropped = eventsDropped.get(),
    )
}

private const val SLOW_NANOS = 5_000_000L
