package badlog.exporter.program

import badlog.core.text.freeName
import badlog.exporter.PAGE_START
import badlog.exporter.reading
import badlog.files.LogName
import badlog.files.wholeLogs
import badlog.viewer.choices.board.BoardLayout
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Decides which files are read and where their pages go. */
internal class ExportPlan(private val arguments: Arguments) {
    private class Input(val file: Path, val isFound: Boolean)

    /**
     * Returns the pages to make, in the order of the arguments, and within a folder by name.
     *
     * @throws badlog.exporter.ExportException if a folder cannot be read.
     */
    fun jobs(): List<ExportJob> {
        val paths = arguments.paths
        val isOnlyLog = paths.size == 1 && !Files.isDirectory(paths[0])
        arguments.out?.let { if (isOnlyLog && !it.isFolder) return listOf(ExportJob(paths[0], it.path, isFound = false)) }
        if (arguments.out == null && paths.size == 2 && isOutput(paths[1]) && !Files.isDirectory(paths[0])) {
            return listOf(ExportJob(paths[0], paths[1], isFound = false))
        }
        val inputs = paths.flatMap { if (Files.isDirectory(it)) logsIn(it) else listOf(Input(it, isFound = false)) }
            .distinctBy { if (Files.exists(it.file)) it.file.toRealPath() else it.file }
            .let { inputs -> wholeLogs(inputs) { it.file } }
        val taken = inputs.mapTo(HashSet()) { keyOf(it.file) }
        return inputs.map { ExportJob(it.file, freePage(it.file, taken), it.isFound) }
    }

    // Returns whether [path] is the output. A missing file with a log's name is a mistyped input. An existing file without
    // such a name is an output only if it is the page of an earlier run, so that a second run does the same.
    private fun isOutput(path: Path) = isPage(path) ||
        (
            !LogName.of(path.fileName?.toString().orEmpty()).mayBeLog &&
                (Files.notExists(path) || (Files.isRegularFile(path) && beginsAsPage(path)))
            )

    private fun isPage(path: Path) = PAGES.any { path.toString().endsWith(it, ignoreCase = true) }

    private fun isLayout(path: Path) = path.toString().endsWith(BoardLayout.ENDING, ignoreCase = true)

    private fun isSource(path: Path) = path.toString().substringAfterLast('.').lowercase() in SOURCES

    private fun beginsAsPage(path: Path) = try {
        Files.newInputStream(path).use { it.readNBytes(PAGE_START.length) }.decodeToString() == PAGE_START
    } catch (_: IOException) {
        // As an input, it is reported with the reason why it cannot be read.
        false
    }

    private fun logsIn(folder: Path): List<Input> = reading(folder) {
        Files.newDirectoryStream(folder) { Files.isRegularFile(it) && !Files.isHidden(it) && !isPage(it) && !isLayout(it) && !isSource(it) }
            .use { files -> files.sortedBy { it.fileName }.map { Input(it, isFound = true) } }
    }

    private fun freePage(input: Path, taken: MutableSet<String>): Path {
        val name = input.fileName.toString()
        val folder = arguments.out?.path ?: input.toAbsolutePath().parent
        return folder.resolve(freeName(name, ".html") { taken.add(keyOf(folder.resolve(it))) })
    }

    // Most laptops' file systems do not distinguish upper from lower case.
    private fun keyOf(path: Path) = path.toAbsolutePath().normalize().toString().lowercase()

    private companion object {
        val PAGES = listOf(".html", ".htm")

        /** The extensions of files that accompany logs in a repository. */
        val SOURCES = setOf("md", "gradle", "lockfile", "java", "kt", "kts", "py", "cpp", "h", "json", "toml", "xml", "yml", "properties")
    }
}
