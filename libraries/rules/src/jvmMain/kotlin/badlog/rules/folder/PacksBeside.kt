package badlog.rules.folder

import badlog.rules.pack.RulePack
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Returns the packs in [folder], in order of their names, whether or not they can be used. None if it cannot be read. */
internal fun packsIn(folder: Path): List<Path> = try {
    Files.newDirectoryStream(folder) { isNamedLikePack(it.fileName.toString()) }.use { it.sortedBy { pack -> pack.fileName.toString() } }
} catch (_: IOException) {
    emptyList()
}

private fun isNamedLikePack(name: String) = !name.startsWith(".") &&
    (name.endsWith(RulePack.ENDING, ignoreCase = true) || name.endsWith(RulePack.ZIP_ENDING, ignoreCase = true))
