package badlog.exporter.program

import badlog.files.LogName
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/** The names of the option that attaches a file. */
internal val ATTACH = arrayOf("-a", "--attach")

/** The endings of pages, in lower case. */
internal val PAGE_ENDINGS: List<String> = listOf(".html", ".htm")

/**
 * Returns [arguments] with the option that attaches before each file: `-a a.txt b.txt` becomes `-a a.txt -a b.txt`. The original allowed both. An
 * existing file follows the first one if its name has an ending that no log or page has.
 */
internal fun withEachAttached(arguments: List<String>): List<String> {
    val all = ArrayList<String>()
    var isAfterFile = false
    for ((index, argument) in arguments.withIndex()) {
        if (argument == "--") return all + arguments.drop(index)
        val isFile = all.lastOrNull() in ATTACH
        if (isAfterFile && !isFile && mayBeAttached(argument)) all += ATTACH[0]
        isAfterFile = isFile || all.lastOrNull() in ATTACH
        all += argument
    }
    return all
}

private fun mayBeAttached(argument: String): Boolean {
    val path = try {
        Path.of(argument)
    } catch (_: InvalidPathException) {
        return false
    }
    val name = path.fileName?.toString().orEmpty()
    val hasEnding = name.lastIndexOf('.') > 0
    return hasEnding && !LogName.of(name).mayBeLog && PAGE_ENDINGS.none { name.endsWith(it, ignoreCase = true) } &&
        Files.isRegularFile(path)
}
