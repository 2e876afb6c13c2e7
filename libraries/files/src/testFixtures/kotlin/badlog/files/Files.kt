package badlog.files

import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream

internal fun gzip(bytes: ByteArray): ByteArray {
    val out = ByteArrayOutputStream()
    GZIPOutputStream(out).use { it.write(bytes) }
    return out.toByteArray()
}

/** Does [work] in a folder that is removed afterwards. */
internal inline fun <T> inFolder(work: (Path) -> T): T {
    val folder = Files.createTempDirectory("badlog")
    try {
        return work(folder)
    } finally {
        folder.toFile().deleteRecursively()
    }
}
