package badlog.lib

import java.io.File
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.file.StandardOpenOption

/**
 * Writes the buffered rows and syncs the file to the disk, four times a second. A loss of power costs no more than that time. The thread
 * holds no lock while it waits for a sync. It also notices if the file was deleted. At the end, it closes the file.
 *
 * @param syncs whether to sync the file to the disk; the rest is always done.
 * @param flush writes the buffered rows.
 */
internal class SyncThread(
    private val file: LogFile,
    private val sink: RowSink,
    private val faults: Faults,
    @Volatile var syncs: Boolean,
    time: LogTime,
    private val flush: () -> Unit,
) : Thread("badlog sync") {
    private var timesMissing = 0
    private val pauses = time.pauses(INTERVAL_MILLIS)

    init {
        isDaemon = true
    }

    override fun run() {
        if (syncs) syncFolder(file.path.absoluteFile.parentFile)
        sync()
        lookForFile()
        while (pauses.next()) {
            flush()
            sync()
            lookForFile()
        }
        sync()
        file.close(faults)
    }

    /** Ends the thread soon, without waiting for it. */
    fun finish() = pauses.end()

    private fun sync() {
        if (!syncs || !sink.isDirty) return
        // Before the sync, so that anything written in the meantime is not missed.
        sink.isDirty = false
        try {
            file.output.sync()
        } catch (failure: IOException) {
            faults.counters.failedSyncs.incrementAndGet()
            faults.reportOnce("sync") {
                "The log ${file.path} could not be synced to the disk: ${describe(failure)}. A power cut may " +
                    "cost more than the last quarter of a second."
            }
        }
    }

    /** Checks twice, because the file may be in the middle of being renamed. */
    private fun lookForFile() {
        timesMissing = if (file.path.exists()) 0 else timesMissing + 1
        val isMissing = timesMissing > 1
        if (isMissing) {
            faults.reportOnce("missing") {
                "The log ${file.path} was deleted, or its disk was removed, while it was being written. From now on, " +
                    "data is lost; restart the robot program to start a new log."
            }
        }
        // Reported before the state changes, so that code that sees the log fail can read why.
        file.isMissing = isMissing
    }
}

/** Syncs the names of [folder]'s files to the disk. Otherwise, a new file could be missing from its folder after a loss of power. */
internal fun syncFolder(folder: File) {
    try {
        FileChannel.open(folder.toPath(), StandardOpenOption.READ).use { it.force(true) }
    } catch (_: IOException) {
        // Some systems do not allow opening a folder; those keep names safe by themselves.
    }
}

private const val INTERVAL_MILLIS = 250L
