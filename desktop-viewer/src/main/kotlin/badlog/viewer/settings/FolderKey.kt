package badlog.viewer.settings

import java.nio.file.Path
import java.security.MessageDigest
import java.util.HexFormat

/** A name for a file of what is kept about [folder]: its path may be longer than a file's name can be. */
internal fun keyOf(folder: Path): String {
    val path = folder.toAbsolutePath().normalize().toString()
    val digest = MessageDigest.getInstance("SHA-256").digest(path.encodeToByteArray())
    return HexFormat.of().formatHex(digest, 0, BYTES)
}

private const val BYTES = 16
