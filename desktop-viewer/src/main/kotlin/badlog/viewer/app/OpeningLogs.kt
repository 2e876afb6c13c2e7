package badlog.viewer.app

import badlog.viewer.library.index.LogEntry
import java.nio.file.Files
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

/** Opens what a person has named: the first folder, or else the first log, with its folder where there is none yet. */
internal fun Viewer.openNamed(files: List<Path>) {
    val folder = files.firstOrNull { Files.isDirectory(it) }
    if (folder != null) return libraryFolder.open(folder)
    val file = files.firstOrNull() ?: return
    if (library.folder == null) file.parent?.let { libraryFolder.open(it, showsNewest = false) }
    openRecording(file)
}

/** Asks for a folder and opens it. */
internal fun chooseFolder(viewer: Viewer) {
    viewer.files.folder("Open a folder of logs", viewer.library.folder)?.let { viewer.libraryFolder.open(it) }
}

/** Asks for a log and opens it, and its folder where there is none yet. */
internal fun chooseFile(viewer: Viewer) {
    viewer.files.toRead("Open a log", viewer.library.folder)?.let { viewer.openNamed(listOf(it)) }
}
