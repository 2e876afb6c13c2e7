package badlog.viewer.recording

import badlog.plot.range.Viewport
import badlog.viewer.app.Viewer
import badlog.viewer.panels.FrontPart
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import java.nio.file.Path

/** Opens recordings in a window and keeps the open one as its file is. A file asked for takes the place of the one before. */
internal class RecordingLoading(private val viewer: Viewer) {
    private val following = RecordingFollowing(viewer)
    private var reading: Job? = null
    private var keeping: Job? = null

    /** Whether a recording is on its way. */
    val isReading: Boolean get() = reading?.isActive == true

    /** Reads [file] and shows it; what is shown now stays until then, and when [file] cannot be read. */
    fun open(file: Path) {
        val path = file.toAbsolutePath().normalize()
        reading?.cancel()
        reading = viewer.tasks.run("Opening ${path.fileName}", { progress -> Stamped.read(path, { viewer.formulas }, progress) }) { read ->
            show(read.recording)
            keeping?.cancel()
            keeping = viewer.scope.launch { following.follow(read.recording, read.stamp) }
        }
    }

    private class Stamped(val recording: OpenRecording, val stamp: FileStamp) {
        companion object {
            fun read(file: Path, definitions: () -> List<String>, progress: (Float) -> Unit): Stamped {
                // Before it is read: what is written meanwhile is a change.
                val stamp = FileStamp.of(file) ?: FileStamp(0, 0)
                return Stamped(OpenRecording.read(file, definitions, progress = progress), stamp)
            }
        }
    }

    private fun show(recording: OpenRecording) {
        viewer.open = recording
        viewer.comparisonLoading.share(recording)
        viewer.graphs = viewer.layouts.graphsOf(recording)
        viewer.viewport = Viewport(recording.span)
        viewer.cursor = null
        viewer.isCursorPinned = false
        viewer.gesture = null
        viewer.selection = null
        viewer.panels = viewer.panels.copy(front = FrontPart.GRAPHS)
        viewer.library = viewer.library.copy(selected = recording.file)
    }
}
