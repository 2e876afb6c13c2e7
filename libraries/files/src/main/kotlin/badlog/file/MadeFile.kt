package badlog.file

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicBoolean

/**
 * A new empty file of the system's kind for what is there only while a log is read, in [folder]; its name tells which program made it. The
 * first call removes what programs have left there that were killed.
 *
 * @param ending the end of its name, such as `.wpilog`.
 */
internal fun newMadeFile(ending: String, folder: Path = Path.of(System.getProperty("java.io.tmpdir"))): Path {
    if (isCleaned.compareAndSet(false, true)) removeLeftFiles(folder)
    return Files.createTempFile(folder, "badlog-${ProcessHandle.current().pid()}-", ending)
}

/** Removes from [folder] what [newMadeFile] has made for programs that no longer run. */
internal fun removeLeftFiles(folder: Path) {
    try {
        Files.newDirectoryStream(folder, "badlog-*").use { files -> files.filter(::isLeft).forEach(::removeQuietly) }
    } catch (_: IOException) {
        // Whoever cleans the folder may do it, too.
    }
}

private fun isLeft(file: Path): Boolean {
    val pid = MADE.matchEntire(file.fileName.toString())?.groupValues?.get(1)?.toLongOrNull() ?: return false
    return ProcessHandle.of(pid).isEmpty
}

private fun removeQuietly(file: Path) {
    try {
        Files.deleteIfExists(file)
    } catch (_: IOException) {
        // It is somebody else's.
    }
}

private val isCleaned = AtomicBoolean()
private val MADE = Regex("badlog-(\\d+)-\\d+\\.(?:wpilog|txt)")
