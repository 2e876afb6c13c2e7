package badlog.catalog.folder

import badlog.core.bag.RecordingParser
import badlog.files.GzipReader
import badlog.files.LogFile
import badlog.files.LogName
import badlog.formats.LOG_FORMATS
import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.util.zip.GZIPInputStream

private const val LARGE = 16L shl 20
private const val SAMPLE = 1 shl 17

/**
 * Returns false if the beginning of a large file shows that it is not a log. So a disk image in a `.gz` need not be read to its end.
 */
internal fun isLikelyLog(file: LogFile): Boolean {
    if (file.size < LARGE || LogName.of(file.name).isOnlyOfLogs) return true
    val parser = RecordingParser(LOG_FORMATS, keepSamples = false)
    Files.newInputStream(file.path).use { stream ->
        try {
            parser.accept(inflated(stream.buffered()).readNBytes(SAMPLE))
        } catch (_: IOException) {
            // Damaged from its first bytes on; reading it will show the details.
            return true
        }
    }
    return parser.finish().isReadable
}

private fun inflated(stream: InputStream): InputStream {
    stream.mark(GzipReader.SIGNATURE_SIZE)
    val head = stream.readNBytes(GzipReader.SIGNATURE_SIZE)
    stream.reset()
    return if (GzipReader.isGzip(head)) GZIPInputStream(stream) else stream
}
