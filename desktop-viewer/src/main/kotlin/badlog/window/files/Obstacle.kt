package badlog.window.files

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Returns the file or folder that prevents files from being written in [folder], which need not exist. Null if none is known. */
internal fun obstacleTo(folder: Path): Path? {
    val nearest = generateSequence(folder.toAbsolutePath()) { it.parent }.firstOrNull { Files.exists(it) }
    return nearest?.takeUnless { Files.isDirectory(it) && (Files.isWritable(it) || takesFile(it)) }
}

/** Returns whether a file can be created in [folder]. On Windows, Java mistakes some folders of a network for read-only ones. */
private fun takesFile(folder: Path): Boolean = try {
    Files.delete(Files.createTempFile(folder, ".badlog-", ".part"))
    true
} catch (_: IOException) {
    false
}
