package badlog.files

import java.io.File
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Returns the path of the program [name] in the folders of [path], the system's PATH. Null if it is in none. On Windows it may end in
 * `.exe`.
 */
public fun programOnPath(name: String, path: String? = System.getenv("PATH")): Path? =
    path.orEmpty().split(File.pathSeparator).filter { it.isNotEmpty() }.firstNotNullOfOrNull { folder ->
        listOf(name, "$name.exe").firstNotNullOfOrNull { file -> executableAt(folder, file) }
    }

private fun executableAt(folder: String, file: String): Path? = try {
    Path.of(folder, file).takeIf { Files.isRegularFile(it) && Files.isExecutable(it) }
} catch (_: InvalidPathException) {
    // A PATH may contain anything.
    null
}
