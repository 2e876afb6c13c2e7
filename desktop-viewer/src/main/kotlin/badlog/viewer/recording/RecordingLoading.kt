package badlog.viewer.recording

import badlog.analysis.LogView
import badlog.bag.BagParser
import badlog.viewer.app.Viewer
import badlog.viewer.graph.standardGraphs
import badlog.viewer.view.Viewport
import java.nio.file.Files
import java.nio.file.Path
import kotlinx.coroutines.Job

/** Opens recordings in a window; a file that is asked for while another is being read takes its place. */
internal class RecordingLoading(private val viewer: Viewer) {
    private var job: Job? = null

    /** Reads [file] and shows it. */
    fun open(file: Path) {
        job?.cancel()
        job = viewer.tasks.run("Opening ${file.fileName}", { read(file) }, ::show)
    }

    private fun read(file: Path): OpenRecording {
        val parser = BagParser(Files.size(file))
        parser.accept(Files.readAllBytes(file))
        return OpenRecording(file.toAbsolutePath().normalize(), LogView.of(parser.finish()))
    }

    private fun show(recording: OpenRecording) {
        viewer.open = recording
        viewer.graphs = standardGraphs(recording.view)
        viewer.viewport = Viewport(recording.span)
        viewer.cursor = null
        viewer.selection = null
    }
}
