package badlog.cli.input

import badlog.file.FolderScan
import badlog.file.LogFile
import badlog.file.NaturalOrder
import badlog.file.UnreadableFileException
import badlog.file.reading
import badlog.file.wholeLogs
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A file to read.
 *
 * @property file where it is.
 * @property folder the folder in which it was found, or null when it was named itself. Nobody is sure that what was found is
 *   a log.
 * @property seen the file as it was found; null when it was named itself.
 */
internal class LogInput(val file: Path, val folder: Path?, val seen: LogFile? = null) {
    /** Whether nobody named it. */
    val isFound: Boolean get() = folder != null

    /** Where it is, seen from the folder in which it was found; its name, when it was named itself. */
    val relativePath: Path get() = folder?.relativize(file) ?: file.fileName
}

/**
 * Finds the logs below files and folders. What a folder holds counts by its name, which is cheap; what is named always.
 *
 * @param checkpoint is called for each file that is looked at.
 */
internal class LogSearch(private val checkpoint: () -> Unit = {}) {
    /**
     * What was found.
     *
     * @property inputs each log once, as the first of its files, in the order of the arguments, and inside a folder in that of their names.
     * @property failures the folders that could not be looked into.
     */
    class SearchResult(val inputs: List<LogInput>, val failures: List<UnreadableFileException>)

    private val inputs = ArrayList<LogInput>()
    private val failures = ArrayList<UnreadableFileException>()
    private val realFolders = HashMap<Path?, Path>()

    /** Looks below [paths]. To be called once. */
    fun find(paths: List<Path>): SearchResult {
        for (path in paths) if (Files.isDirectory(path)) lookInto(path) else inputs += LogInput(path, null)
        return SearchResult(wholeLogs(inputs.distinctBy { identityOf(it.file) }) { it.file }, failures)
    }

    private fun lookInto(folder: Path) {
        try {
            val scan = reading(folder) { FolderScan.of(folder, checkpoint) }
            val files = scan.files.sortedWith(compareBy(NaturalOrder) { it.path.toString() })
            files.mapTo(inputs) { LogInput(it.path, folder, it) }
            scan.unreadable.mapTo(failures) {
                UnreadableFileException(it, "$it cannot be read: permission denied; ask its owner.")
            }
        } catch (e: UnreadableFileException) {
            failures += e
        }
    }

    // To follow all folders of each file takes long where there are a thousand.
    private fun identityOf(file: Path): Path = try {
        val folder = file.parent
        if (Files.isSymbolicLink(file)) {
            file.toRealPath()
        } else {
            realFolders.getOrPut(folder) { (folder ?: Path.of("")).toRealPath() }.resolve(file.fileName)
        }
    } catch (_: IOException) {
        file.toAbsolutePath().normalize()
    }
}
