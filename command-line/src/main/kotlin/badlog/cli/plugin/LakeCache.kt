package badlog.cli.plugin

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32
import kotlin.io.path.isDirectory
import kotlin.io.path.name

/**
 * The lakes that badlog makes for itself: one for each queried folder of logs.
 *
 * @param answers the folder of cached answers; the lakes are beside it.
 * @param layoutVersion the version of their layout.
 */
public class LakeCache(private val answers: Path, private val layoutVersion: Int) {
    /**
     * Returns the place of the lake of [folder], which must exist. Removes lakes of former layouts, which are no longer readable.
     *
     * @param user the name of another user, who has a separate lake of the same folder; empty for the person at the command line.
     */
    public fun lakeOf(folder: Path, user: String = ""): Path {
        removeFormer()
        val real = folder.toRealPath()
        val key = CRC32().apply { update(real.toString().encodeToByteArray()) }.value.toString(HEX)
        val prefix = if (user.isEmpty()) "" else "$user-"
        return answers.resolveSibling("$NAME$layoutVersion").resolve("$prefix${real.fileName ?: "root"}-$key")
    }

    private fun removeFormer() {
        try {
            val parent = answers.toAbsolutePath().parent
            if (!parent.isDirectory()) return
            val former = Files.list(parent).use { all -> all.filter { isFormer(it.name) }.toList() }
            for (lakes in former) lakes.toFile().deleteRecursively()
        } catch (_: IOException) {
            // They only take space.
        }
    }

    private fun isFormer(name: String): Boolean =
        name == WITHOUT_VERSION || (name.startsWith(NAME) && (name.removePrefix(NAME).toIntOrNull() ?: layoutVersion) < layoutVersion)
}

private const val NAME = "lakes-v"

/** The name of the folder of lakes before layouts had versions. */
private const val WITHOUT_VERSION = "lakes"
private const val HEX = 16
