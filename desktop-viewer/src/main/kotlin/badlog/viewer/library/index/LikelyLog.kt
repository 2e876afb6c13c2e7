package badlog.viewer.library.index

import badlog.bag.RecordingParser
import badlog.file.GzipReader
import badlog.file.LogFile
import badlog.formats.LOG_FORMATS
import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.util.zip.GZIPInputStream

private val NAMED_AS_LOG = Regex(".*\\.(bag|badbag|wpilog)(\\.gz)?", RegexOption.IGNORE_CASE)
private const val LARGE = 16L shl 20
private const val SAMPLE = 1 shl 17

/** Whether [name] can only be that of a log. */
internal fun isNamedAsLog(name: String): Boolean = NAMED_AS_LOG.matches(name)

/**
 * False for a large file that shows at its beginning that it is no log: a disk image in a `.gz` is not to be read to its end to
 * learn that.
 */
internal fun isLikelyLog(file: LogFile): Boolean {
    if (file.size < LARGE || isNamedAsLog(file.name)) return true
    val parser = RecordingParser(LOG_FORMATS, keepSamples = false)
    Files.newInputStream(file.path).use { stream ->
        try {
            parser.accept(inflated(stream.buffered()).readNBytes(SAMPLE))
        } catch (_: IOException) {
            // Damaged from its first bytes on; reading it tells how.
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
