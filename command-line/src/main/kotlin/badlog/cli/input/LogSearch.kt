package badlog.cli.input

import badlog.catalog.match.MatchMaker
import badlog.files.FolderScan
import badlog.files.LogFile
import badlog.files.UnreadableFileException
import badlog.files.reading
import badlog.files.unreadable
import badlog.files.wholeLogs
import badlog.signals.match.NaturalOrder
import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A file to read.
 *
 * @property file its path.
 * @property folder the folder in which it was found, or null if it was named itself. A file that was found may not be a log.
 * @property seen the file as it was found; null if it was named itself.
 */
internal class LogInput(val file: Path, val folder: Path?, val seen: LogFile? = null) {
    /** Whether it was found in a folder, rather than named. */
    val isFound: Boolean get() = folder != null

    /** Its path relative to the folder in which it was found; its name, if it was named itself. */
    val relativePath: Path get() = folder?.relativize(file) ?: file.fileName
}

/**
 * Finds the logs below files and folders. Files in a folder are selected by name, which is cheap; named files are
 * always included.
 *
 * @param opensMatches whether a `match.json` in a folder is one log, in place of the files that it names.
 * @param checkpoint called for each file.
 */
internal class LogSearch(private val opensMatches: Boolean = false, private val checkpoint: () -> Unit = {}) {
    /**
     * The result of a search.
     *
     * @property inputs each log once, as the first of its files: in the order of the arguments, and within a folder by name.
     * @property failures the folders that could not be read.
     */
    class SearchResult(val inputs: List<LogInput>, val failures: List<UnreadableFileException>)

    private val inputs = ArrayList<LogInput>()
    private val failures = ArrayList<UnreadableFileException>()
    private val realFolders = HashMap<Path?, Path>()

    /** Searches below [paths]. Call it once. */
    fun find(paths: List<Path>): SearchResult {
        for (path in paths) {
            val manifest = if (opensMatches) MatchMaker.manifestIn(path) else null
            if (manifest != null) {
                inputs += LogInput(manifest, null)
                lookInto(path, MatchMaker.filesOf(manifest))
            } else if (Files.isDirectory(path)) {
                lookInto(path)
            } else {
                inputs += LogInput(path, null)
            }
        }
        return SearchResult(wholeLogs(inputs.distinctBy { identityOf(it.file) }) { it.file }, failures)
    }

    private fun lookInto(folder: Path, except: Set<Path> = emptySet()) {
        try {
            val scan = reading(folder) { FolderScan.of(folder, checkpoint) }
            val files = scan.files.filter { it.path !in except }.sortedWith(compareBy(NaturalOrder) { it.path.toString() })
            files.mapTo(inputs) { LogInput(it.path, folder, it) }
            scan.unreadable.mapTo(failures) { unreadable(it, AccessDeniedException("$it")) }
        } catch (e: UnreadableFileException) {
            failures += e
        }
    }

    // Resolving all folders of each file would take long for a thousand files.
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
