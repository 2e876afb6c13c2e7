package badlog.files

import java.io.IOException
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.LinkOption
import java.nio.file.Path
import java.nio.file.attribute.FileAttribute
import java.nio.file.attribute.PosixFilePermissions
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.random.Random

/**
 * Creates an empty temporary file in [folder], for use while a log is read. Its name identifies the program that made it. The first call
 * removes files left there by killed programs.
 *
 * @param ending the end of its name, such as `.wpilog`.
 * @throws UnwritableFileException if [folder] cannot be written to.
 */
internal fun newMadeFile(ending: String, folder: Path = Path.of(System.getProperty("java.io.tmpdir"))): Path {
    if (isCleaned.compareAndSet(false, true)) removeLeftFiles(folder)
    return writing(folder) { Files.createTempFile(folder, "badlog-${ProcessHandle.current().pid()}-", ending) }
}

/** Removes the files and folders in [folder] that [newMadeFile] and [inMadeFolder] made for programs no longer running. */
internal fun removeLeftFiles(folder: Path) {
    try {
        val left = Files.newDirectoryStream(folder, "badlog-*").use { files -> files.filter(::isLeft) }
        for (file in left) if (!Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS) || isOwn(file)) removeQuietly(file)
    } catch (_: IOException) {
        // Something else may clean up the folder instead.
    }
}

/**
 * Returns the result of [work] in a new temporary folder, which is removed afterwards.
 *
 * @throws UnwritableFileException if the folder cannot be created.
 */
public fun <T> inMadeFolder(work: (Path) -> T): T {
    val parent = Path.of(System.getProperty("java.io.tmpdir"))
    if (isCleaned.compareAndSet(false, true)) removeLeftFiles(parent)
    val folder = writing(parent) { Files.createDirectory(parent.resolve(newFolderName()), *onlyForOwner()) }
    try {
        return work(folder)
    } finally {
        removeQuietly(folder)
    }
}

private fun newFolderName() = "badlog-${ProcessHandle.current().pid()}-${Random.nextLong(MIN_NUMBER, MIN_NUMBER * 10)}.match"

private fun onlyForOwner(): Array<FileAttribute<*>> {
    // Windows has no such permissions, and a folder there for each user.
    if ("posix" !in FileSystems.getDefault().supportedFileAttributeViews()) return emptyArray()
    return arrayOf(PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")))
}

private fun isLeft(file: Path): Boolean {
    // No other folder may be emptied, so only one that badlog surely made is.
    val made = if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) MADE_FOLDER else MADE_FILE
    val pid = made.matchEntire(file.fileName.toString())?.groupValues?.get(1)?.toLongOrNull() ?: return false
    return ProcessHandle.of(pid).isEmpty
}

/** Whether [folder] belongs to the user of this program. Another user may put a link into his own at any time. */
private fun isOwn(folder: Path): Boolean {
    val own = Files.createTempFile("badlog-${ProcessHandle.current().pid()}-", ".txt")
    try {
        return Files.getOwner(folder, LinkOption.NOFOLLOW_LINKS) == Files.getOwner(own)
    } finally {
        Files.deleteIfExists(own)
    }
}

private fun removeQuietly(file: Path) {
    try {
        if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
            Files.newDirectoryStream(file).use { inside -> inside.forEach(::removeQuietly) }
        }
        Files.deleteIfExists(file)
    } catch (_: IOException) {
        // It belongs to another user.
    }
}

private val isCleaned = AtomicBoolean()
private val MADE_FILE = Regex("badlog-(\\d+)-\\d+\\.(?:wpilog|txt)")
private val MADE_FOLDER = Regex("badlog-(\\d+)-\\d{10}\\.match")

/** The least number of ten digits. */
private const val MIN_NUMBER = 1_000_000_000L
