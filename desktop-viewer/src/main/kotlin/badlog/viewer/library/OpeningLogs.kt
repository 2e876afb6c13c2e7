package badlog.viewer.library

import badlog.viewer.app.Viewer
import badlog.viewer.library.index.LogEntry
import java.nio.file.Path

/** Shows the recording of [file]. */
internal fun Viewer.openRecording(file: Path) = loading.open(file)

/** Shows [entry], or says why it cannot be shown. */
internal fun Viewer.openLog(entry: LogEntry) {
    library = library.copy(selected = entry.file)
    if (entry.trouble == null) openRecording(entry.file) else notices.complain("${entry.fileName}: ${entry.trouble}")
}

/** Shows the log [steps] further down the list than the one that is selected. */
internal fun Viewer.openStepped(steps: Int) {
    val next = library.stepped(steps) ?: return
    if (next.file != library.selected) openLog(next)
}
