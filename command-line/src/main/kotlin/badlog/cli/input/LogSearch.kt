package badlog.cli.input

import badlog.file.UnreadableFileException
import badlog.file.reading
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Finds the logs below files and folders. What a folder holds counts by its name, which is cheap; what is named always. */
internal class LogSearch {
    /**
     * What was found.
     *
     * @property inputs each log once, in the order of the arguments, and inside a folder in that of their names.
     * @property failures the folders that could not be looked into.
     */
    class Found(val inputs: List<LogInput>, val failures: List<UnreadableFileException>)

    private val inputs = ArrayList<LogInput>()
    private val failures = ArrayList<UnreadableFileException>()
    private val seenFolders = HashSet<Path>()

    /** Looks below [paths]. To be called once. */
    fun find(paths: List<Path>): Found {
        for (path in paths) if (Files.isDirectory(path)) lookInto(path, path) else inputs += LogInput(path, null)
        return Found(inputs.distinctBy { identityOf(it.file) }, failures)
    }

    private fun lookInto(folder: Path, top: Path) {
        try {
            // A link may lead back to where it stands.
            if (!seenFolders.add(reading(folder) { folder.toRealPath() })) return
            val entries = reading(folder) { Files.newDirectoryStream(folder).use { it.sortedBy(Path::toString) } }
            for (entry in entries) {
                if (entry.fileName.toString().startsWith(".")) continue
                if (Files.isDirectory(entry)) lookInto(entry, top) else if (isNamedLikeALog(entry)) inputs += LogInput(entry, top)
            }
        } catch (e: UnreadableFileException) {
            failures += e
        }
    }

    private fun isNamedLikeALog(file: Path) = ENDINGS.any { file.toString().endsWith(it, ignoreCase = true) }

    private fun identityOf(file: Path): Path = try {
        file.toRealPath()
    } catch (_: IOException) {
        file.toAbsolutePath().normalize()
    }

    private companion object {
        val ENDINGS = listOf(".bag", ".badbag", ".csv", ".gz", ".wpilog")
    }
}
