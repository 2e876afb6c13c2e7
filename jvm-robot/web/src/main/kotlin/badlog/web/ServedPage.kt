package badlog.web

import java.io.InputStream
import java.util.zip.CRC32

/** The page in this jar, as gzip. */
internal class ServedPage {
    /** Its length in bytes. */
    val size: Long

    /** The HTTP entity tag (ETag) of its bytes. */
    val tag: String

    init {
        val checksum = CRC32()
        var size = 0L
        val buffer = ByteArray(BUFFER_BYTES)
        open().use { stream ->
            while (true) {
                val count = stream.read(buffer)
                if (count < 0) break
                checksum.update(buffer, 0, count)
                size += count
            }
        }
        this.size = size
        tag = "\"${checksum.value.toString(16)}\""
    }

    /** Returns its bytes. */
    fun open(): InputStream = checkNotNull(ServedPage::class.java.getResourceAsStream(RESOURCE)) {
        "$RESOURCE is missing in this build of badlog."
    }
}

private const val RESOURCE = "/badlog/web/logs.html.gz"
private const val BUFFER_BYTES = 8192
