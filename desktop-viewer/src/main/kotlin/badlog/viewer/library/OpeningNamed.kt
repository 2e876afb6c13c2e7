package badlog.viewer.library

import badlog.viewer.app.Viewer
import java.nio.file.Files
import java.nio.file.Path

/** Opens what a person has named: the first folder, or else the first log, with its folder where there is none yet. */
internal fun Viewer.openNamed(files: List<Path>) {
    val folder = files.firstOrNull { Files.isDirectory(it) }
    if (folder != null) return libraryFolder.open(folder)
    val file = files.firstOrNull() ?: return
    if (library.folder == null) file.parent?.let { libraryFolder.open(it, showsNewest = false) }
    openRecording(file)
}
