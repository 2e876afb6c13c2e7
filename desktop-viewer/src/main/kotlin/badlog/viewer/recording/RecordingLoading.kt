package badlog.viewer.recording

import badlog.analysis.LogView
import badlog.file.readRecording
import badlog.viewer.app.FrontPart
import badlog.viewer.app.Viewer
import badlog.viewer.view.Viewport
import java.nio.file.Path
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch

/** Opens recordings in a window and keeps the open one as its file is. A file asked for takes the place of the one before. */
internal class RecordingLoading(private val viewer: Viewer) {
    private var job: Job? = null
    private val following = RecordingFollowing(viewer) { shown, isGrowing -> read(shown.file, isGrowing) {} }

    /** Reads [file] and shows it; what is shown now stays until then, and when [file] cannot be read. */
    fun open(file: Path) {
        val path = file.toAbsolutePath().normalize()
        val stamp = FileStamp.of(path) ?: FileStamp(0, 0)
        job?.cancel()
        job = viewer.tasks.run("Opening ${path.fileName}", { progress -> read(path, false, progress) }) { recording ->
            show(recording)
            job = viewer.scope.launch { following.follow(recording, stamp) }
        }
    }

    private fun read(file: Path, isGrowing: Boolean, progress: (Float) -> Unit): OpenRecording {
        val recording = readRecording(file, untilLastLineEnd = isGrowing) { done, total ->
            if (total > 0) progress(done.toFloat() / total)
        }
        // When it was enabled is drawn in the first frame; the window's thread must not have to look for it.
        return OpenRecording(file, LogView.of(recording)).also { it.enabled }
    }

    private fun show(recording: OpenRecording) {
        viewer.open = recording
        viewer.graphs = viewer.layouts.graphsOf(recording)
        viewer.viewport = Viewport(recording.span)
        viewer.cursor = null
        viewer.isCursorPinned = false
        viewer.gesture = null
        viewer.selection = null
        viewer.panels = viewer.panels.copy(front = FrontPart.GRAPHS)
    }
}
