package badlog.window.log

import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.window.task.Notices
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.runInterruptible
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.TimeSource

/**
 * Watches the file of the open recording, which a robot's simulation may be writing. While it grows, an incomplete row is left for later.
 *
 * @param read reads the file again: up to its last line end, or all of it.
 * @param update shows the new content, and whether the file grows.
 * @param ended is called when the file is gone, or too large to be read.
 */
internal class RecordingWatcher(
    private val notices: Notices,
    private val read: (OpenRecording, isGrowing: Boolean) -> OpenRecording,
    private val update: (OpenRecording, isGrowing: Boolean) -> Unit,
    private val ended: () -> Unit = {},
) {
    /** Watches the file of [opened], which was read when the file had the [stamp], until cancelled. */
    suspend fun watch(opened: OpenRecording, stamp: FileStamp) {
        var shown = opened
        var known = stamp
        var isSettled = true
        var misses = 0
        var quietSince = TimeSource.Monotonic.markNow()
        while (true) {
            delay(POLL)
            val now = runInterruptible(Dispatchers.IO) { FileStamp.of(shown.file) }
            if (now == null && ++misses < MISSES) continue
            if (now == null) {
                notices.say("${shown.file.fileName} was removed from its folder; the data read so far stays open.")
                return ended()
            }
            misses = 0
            val hasChanged = now != known
            if (hasChanged) quietSince = TimeSource.Monotonic.markNow()
            if (!hasChanged && (isSettled || quietSince.elapsedNow() < SETTLED)) continue
            known = now
            isSettled = !hasChanged
            val began = TimeSource.Monotonic.markNow()
            val again = try {
                readAgain(shown, isGrowing = hasChanged)
            } catch (e: NotReadException) {
                return stopWatching(shown.file, e)
            } catch (e: OutOfMemoryError) {
                return stopWatching(shown.file, e)
            }
            if (again == null) {
                isSettled = false
                continue
            }
            shown = again
            update(shown, hasChanged)
            // Reading a large file repeatedly must not slow down the program that writes it.
            delay(began.elapsedNow())
        }
    }

    private fun stopWatching(file: Path, failure: Throwable) {
        notices.complain("${ReadResult.NotRead.of(file, failure).sentence} The data read so far stays open.")
        ended()
    }

    /** Returns [shown] with its current content. Null if it could not be read: the next check shows whether the file is gone. */
    private suspend fun readAgain(shown: OpenRecording, isGrowing: Boolean): OpenRecording? = try {
        runInterruptible(Dispatchers.IO) { read(shown, isGrowing) }
    } catch (e: NotReadException) {
        if (e.why.cause == ReadResult.Cause.TOO_LARGE) throw e else null
    } catch (_: IOException) {
        null
    }

    private companion object {
        /** The time between two checks. If reading the log takes as long, a new row is on the screen after 0.3 s. */
        val POLL = 80.milliseconds

        /** The number of checks after which a missing file counts as gone: a program that replaces it takes a moment. */
        const val MISSES = 5

        /** The time without a change after which a file is read to its end. A recorder with nothing to record writes the time each 5 s. */
        val SETTLED = 6000.milliseconds
    }
}

/**
 * The attributes of a file that show whether it has changed.
 *
 * @property size the size in bytes.
 * @property modifiedMillis the time of the last change, in milliseconds since 1970.
 */
internal data class FileStamp(val size: Long, val modifiedMillis: Long) {
    companion object {
        /** Returns the current stamp of [file]; null if it does not exist or cannot be accessed. */
        fun of(file: Path): FileStamp? = try {
            val attributes = Files.readAttributes(file, BasicFileAttributes::class.java)
            FileStamp(attributes.size(), attributes.lastModifiedTime().toMillis())
        } catch (_: IOException) {
            null
        }
    }
}
