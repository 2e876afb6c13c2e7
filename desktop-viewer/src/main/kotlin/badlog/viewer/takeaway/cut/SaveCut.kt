package badlog.viewer.takeaway.cut

import badlog.plot.Span
import badlog.recording.RecordingFormat
import badlog.viewer.app.Viewer
import badlog.viewer.files.askToWrite
import badlog.viewer.files.stemOf

/** The part of x that a cut takes: the selection, or else what is visible. */
internal fun cutSpan(viewer: Viewer): Span = viewer.selection ?: viewer.viewport.visible

/** Asks for a file, and writes the selection or else the visible range of the open recording to it as [format]. */
internal fun saveCut(viewer: Viewer, format: RecordingFormat) {
    val recording = viewer.open ?: return
    val span = cutSpan(viewer)
    val ending = if (format == RecordingFormat.BAG) ".bag" else ".csv"
    val title = if (viewer.selection != null) "Save the selection" else "Save the visible range"
    val target = askToWrite(viewer, title, recording.file.parent, "${stemOf(recording.file)} part", ending) ?: return
    viewer.tasks.run("Writing ${target.fileName}", { cutFile(recording, span, format, target, it) }) { rows ->
        viewer.notices.say("Wrote $rows rows to $target.")
    }
}
