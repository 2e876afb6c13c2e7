package badlog.window.log

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.files.LogFile
import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.signals.clock.FoundStation
import badlog.viewer.choices.board.FolderLayout
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runInterruptible
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.TimeSource

/**
 * Opens recordings, and keeps the open one up to date with its file. A requested file replaces the previous one. Use it only on the
 * window's thread.
 *
 * @param scope the scope for watching files; its thread is the window's.
 * @param watcher keeps the open recording up to date with its file.
 * @param reader reads recordings.
 * @param definitions returns the formulas to calculate in an opened log, given the layout beside it.
 * @param show shows a recording.
 */
internal class RecordingLoader(
    private val scope: CoroutineScope,
    private val tasks: LongTasks,
    private val watcher: RecordingWatcher,
    private val reader: RecordingReader,
    private val definitions: (Path, FolderLayout) -> List<String>,
    private val show: (OpenRecording) -> Unit,
) {
    private var reading: Job? = null
    private var watching: Job? = null

    /** Whether a recording is being read. */
    var isReading: Boolean by mutableStateOf(false)
        private set

    /** Reads [file] and shows it; the current recording stays until then, and if [file] cannot be read. */
    fun open(file: Path) {
        val path = file.toAbsolutePath().normalize()
        reading?.cancel()
        val work = { progress: (Float) -> Unit -> Stamped.read(path) { reader.read(path, definitions = definitions, progress = progress) } }
        val job = tasks.run("Opening ${path.fileName}", work) { read ->
            show(read.recording)
            watching?.cancel()
            watching = scope.launch { watcher.watch(read.recording, read.stamp) }
        }
        reading = job
        isReading = true
        job.invokeOnCompletion { if (reading === job) isReading = false }
    }

    /** Stops reading, and no longer keeps the open recording up to date. */
    fun stop() {
        reading?.cancel()
        watching?.cancel()
    }

    private class Stamped(val recording: OpenRecording, val stamp: FileStamp) {
        companion object {
            fun read(file: Path, read: () -> OpenRecording): Stamped {
                // Determined before reading: anything written meanwhile counts as a change.
                val stamp = FileStamp.of(file) ?: FileStamp(0, 0)
                return Stamped(read(), stamp)
            }
        }
    }
}

/**
 * Reads recordings as the window shows them, off its thread.
 *
 * @param library returns the folder of logs.
 * @param choices returns a person's choices for a log.
 */
internal class RecordingReader(private val library: () -> Path?, private val choices: (Path) -> RecordingChoices) {
    /**
     * Reads [file], see [OpenRecording.read].
     *
     * @param definitions returns the formulas to calculate in a log, given the layout beside it; null for the chosen formulas.
     */
    fun read(
        file: Path,
        isGrowing: Boolean = false,
        definitions: ((Path, FolderLayout) -> List<String>)? = null,
        progress: (Float) -> Unit = {},
    ): OpenRecording {
        fun choicesFor(layout: FolderLayout): RecordingChoices {
            val chosen = choices(file)
            return if (definitions == null) chosen else chosen.copy(definitions = definitions(file, layout))
        }
        return OpenRecording.read(file, library(), isGrowing, ::choicesFor, progress)
    }
}

/**
 * A person's choices for one log: formulas, x axis, Driver Station log, and field.
 *
 * @property definitions the definitions of the formulas calculated in it.
 * @property overTime whether it is drawn over its time if it names no x axis.
 * @property station the Driver Station's log of the same match that is shown with it; null for none.
 * @property field the file of the field on which its paths are drawn; null for the field beside the log.
 * @property fieldSelections the number of a person's selections of a field: the same file may have changed in between.
 */
internal data class RecordingChoices(
    val definitions: List<String> = emptyList(),
    val overTime: Boolean = false,
    val station: FoundStation<LogFile>? = null,
    val field: Path? = null,
    val fieldSelections: Int = 0,
)

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
