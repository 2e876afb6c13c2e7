package badlog.window.settings

import java.nio.file.Path
import java.security.MessageDigest
import java.util.HexFormat

/** Returns a name for a file with data about [folder]. The folder's path may be too long for a file name. */
internal fun keyOf(folder: Path): String {
    val path = folder.toAbsolutePath().normalize().toString()
    val digest = MessageDigest.getInstance("SHA-256").digest(path.encodeToByteArray())
    return HexFormat.of().formatHex(digest, 0, BYTES)
}

private const val BYTES = 16
