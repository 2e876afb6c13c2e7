package badlog.html.cli

import badlog.html.reading
import java.nio.file.Files
import java.nio.file.Path

/** Decides which files are read and where their pages go. */
internal class ExportPlan(private val arguments: Arguments) {
    private class Input(val file: Path, val isFound: Boolean)

    /**
     * The pages to make, in the order of the arguments, and inside a folder in the order of its files' names.
     *
     * @throws badlog.html.ExportException when a folder cannot be read.
     */
    fun jobs(): List<ExportJob> {
        val paths = arguments.paths
        if (arguments.outFolder == null && paths.size == 2 && isOutput(paths[1]) && !Files.isDirectory(paths[0])) {
            return listOf(ExportJob(paths[0], paths[1], isFound = false))
        }
        val inputs = paths.flatMap { if (Files.isDirectory(it)) logsIn(it) else listOf(Input(it, isFound = false)) }
            .distinctBy { if (Files.exists(it.file)) it.file.toRealPath() else it.file }
        val taken = inputs.mapTo(HashSet()) { keyOf(it.file) }
        return inputs.map { ExportJob(it.file, freePage(it.file, taken), it.isFound) }
    }

    private fun isOutput(path: Path) = Files.notExists(path) || isPage(path)

    private fun isPage(path: Path) = path.toString().endsWith(".html", ignoreCase = true)

    private fun logsIn(folder: Path): List<Input> = reading(folder) {
        Files.newDirectoryStream(folder) { Files.isRegularFile(it) && !Files.isHidden(it) && !isPage(it) }
            .use { files -> files.sortedBy { it.fileName }.map { Input(it, isFound = true) } }
    }

    private fun freePage(input: Path, taken: MutableSet<String>): Path {
        val name = input.fileName.toString()
        val folder = arguments.outFolder ?: input.toAbsolutePath().parent
        return generateSequence(1) { it + 1 }
            .map { folder.resolve(if (it == 1) "$name.html" else "$name ($it).html") }
            .first { taken.add(keyOf(it)) }
    }

    // Most disks of laptops do not tell upper from lower case.
    private fun keyOf(path: Path) = path.toAbsolutePath().normalize().toString().lowercase()
}
