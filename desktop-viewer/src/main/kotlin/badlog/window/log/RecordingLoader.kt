package badlog.window.log

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.viewer.choices.board.FolderLayout
import badlog.window.task.LongTasks
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import java.nio.file.Path

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
