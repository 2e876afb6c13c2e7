package badlog.viewer.library.index

import badlog.bag.FileSignature
import badlog.file.LogFile
import badlog.file.RecordingParser
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
    val parser = RecordingParser(keepSamples = false)
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
    stream.mark(FileSignature.BYTES)
    val head = stream.readNBytes(FileSignature.BYTES)
    stream.reset()
    return if (FileSignature.of(head, head.size) == FileSignature.GZIP) GZIPInputStream(stream) else stream
}
