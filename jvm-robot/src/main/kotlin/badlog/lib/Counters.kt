package badlog.lib

import java.util.concurrent.atomic.AtomicLong

/** The counters while they count. Atomic because any thread reads them, and a robot's CPU may tear a plain long. */
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

    fun rowTook(nanos: Long) {
        if (nanos > slowestRow.get()) slowestRow.set(nanos)
    }

    fun writeTook(nanos: Long) {
        if (nanos > SLOW_NANOS) slowWrites.incrementAndGet()
    }

    fun wrote(rows: Int) {
        rowsWritten.addAndGet(rows.toLong())
    }

    fun grewTo(fileLength: Long) = bytesWritten.set(fileLength)

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

    private companion object {
        const val SLOW_NANOS = 5_000_000L
    }
}
