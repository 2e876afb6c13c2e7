package badlog.viewer.files

import badlog.viewer.app.Viewer
import java.nio.file.Files
import java.nio.file.Path

/**
 * Asks for a file to write whose name ends in [ending], [name] if the person likes; null when nothing is to be written. What is
 * there already is replaced only when the person has named it in full, and so has agreed to that in the dialog.
 */
internal fun askToWrite(viewer: Viewer, title: String, folder: Path?, name: String, ending: String): Path? {
    val chosen = viewer.files.toWrite(title, folder, name + ending) ?: return null
    if (chosen.fileName.toString().endsWith(ending, ignoreCase = true)) return chosen
    val file = chosen.resolveSibling("${chosen.fileName}$ending")
    if (!Files.exists(file)) return file
    viewer.notices.complain("${file.fileName} is there already; choose it with its full name to replace it.")
    return null
}

/** Says that there is no log yet of which something could be taken. */
internal fun sayNoLog(viewer: Viewer) = viewer.notices.complain("Open a log first.")
