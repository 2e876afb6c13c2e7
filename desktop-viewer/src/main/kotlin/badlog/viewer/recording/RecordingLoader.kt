package badlog.viewer.recording

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.viewer.task.LongTasks
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import java.nio.file.Path

/**
 * Opens recordings and keeps the open one as its file is. A file asked for takes the place of the one before. To be used on the
 * window's thread only.
 *
 * @param scope where files are watched; its thread is the window's.
 * @param watcher keeps what was opened as its file is.
 * @param reader reads them.
 * @param show shows what was read.
 */
internal class RecordingLoader(
    private val scope: CoroutineScope,
    private val tasks: LongTasks,
    private val watcher: RecordingWatcher,
    private val reader: RecordingReader,
    private val show: (OpenRecording) -> Unit,
) {
    private var reading: Job? = null
    private var watching: Job? = null

    /** Whether a recording is on its way. */
    var isReading: Boolean by mutableStateOf(false)
        private set

    /** Reads [file] and shows it; what is shown now stays until then, and when [file] cannot be read. */
    fun open(file: Path) {
        val path = file.toAbsolutePath().normalize()
        reading?.cancel()
        val work = { progress: (Float) -> Unit -> Stamped.read(path) { reader.read(path, progress = progress) } }
        val job = tasks.run("Opening ${path.fileName}", work) { read ->
            show(read.recording)
            watching?.cancel()
            watching = scope.launch { watcher.watch(read.recording, read.stamp) }
        }
        reading = job
        isReading = true
        job.invokeOnCompletion { if (reading === job) isReading = false }
    }

    private class Stamped(val recording: OpenRecording, val stamp: FileStamp) {
        companion object {
            fun read(file: Path, read: () -> OpenRecording): Stamped {
                // Before it is read: what is written meanwhile is a change.
                val stamp = FileStamp.of(file) ?: FileStamp(0, 0)
                return Stamped(read(), stamp)
            }
        }
    }
}
