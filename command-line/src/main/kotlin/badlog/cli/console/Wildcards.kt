package badlog.cli.console

import badlog.files.missingSentence
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * Returns [arguments] with the names of matching files in place of patterns such as `*.bag`. On other systems, the shell does that. On
 * Windows, a pattern in quotes reaches the program, and a path cannot contain its characters. An argument that matches no file is
 * unchanged, because expressions have `*` and `?`, too.
 *
 * A `?` also replaces each letter that Windows could not pass on, so an argument with `?` must match only one file. The prefix `\\?\` of long
 * paths is removed: Java adds it where it is needed.
 *
 * @param system the name of the operating system.
 */
internal fun withWildcards(arguments: List<String>, system: String = System.getProperty("os.name")): List<String> =
    if (system.startsWith("Windows")) arguments.map(::withoutLongPathPrefix).flatMap { matching(it).ifEmpty { listOf(it) } } else arguments

private fun withoutLongPathPrefix(argument: String) = LONG_PATH_PREFIX.replace(argument) { found ->
    found.groupValues[1] + if (found.groupValues[2].isEmpty()) "" else NETWORK_PREFIX
}

private fun matching(argument: String): List<String> {
    if (argument.none { it in WILD } || argument.startsWith("-")) return emptyList()
    val start = argument.lastIndexOfAny(charArrayOf('/', '\\')) + 1
    val head = argument.substring(0, start)
    val folder = try {
        Path.of(head)
    } catch (_: InvalidPathException) {
        return emptyList()
    }
    if (!folder.isDirectory() || !Files.isReadable(folder)) return emptyList()
    val pattern = argument.substring(start).map {
        if (it == '*') {
            ".*"
        } else if (it == '?') {
            "."
        } else {
            Regex.escape("$it")
        }
    }
    val name = Regex(pattern.joinToString(""), RegexOption.IGNORE_CASE)
    val names = folder.listDirectoryEntries().map { it.name }.filter(name::matches).sorted()
    return if (names.size > 1 && '?' in argument) emptyList() else names.map { head + it }
}

/**
 * Returns advice on the argument at the end of Java's [message], which is not a path on Windows. Null if it is not in [arguments], or if
 * [system] is not Windows.
 */
internal fun unreachable(arguments: List<String>, message: String, system: String = System.getProperty("os.name")): String? {
    val path = oneLine(message).split(BEFORE_PATH, limit = 2).getOrNull(1)
    if (path == null || !system.startsWith("Windows")) return null
    // A formula has these letters, too.
    val argument = arguments.filter { it.any(WILD::contains) && path.startsWith(oneLine(it)) }.maxByOrNull { it.length } ?: return null
    // Elsewhere, a pattern that matches no file is looked for as a file of that name.
    if ('?' !in argument) return missingSentence(argument)
    return "“$argument” has characters that Windows did not pass on, or stands for several files; name the folder above it."
}

// The help may break long lines.
private fun oneLine(text: String) = text.trim().replace(Regex("\\s+"), " ")

private const val WILD = "*?"

/** The text before the path in Java's message: `Illegal char <*> at index 0: *.bag`. */
private val BEFORE_PATH = Regex("Illegal char <.> at index \\d+: ")

/** `\\?\C:\…` or `\\?\UNC\server\…`, as an argument or as the value of an option. */
private val LONG_PATH_PREFIX = Regex("""^(--[a-z-]+=)?\\\\\?\\(UNC\\)?""")
private const val NETWORK_PREFIX = "\\\\"
