package badlog.cli.input

import badlog.file.LogName
import badlog.report.startOfBytes
import badlog.text.freeName
import java.nio.file.Path

/**
 * The parts of a log's name: `match.bag.gz` is `match`, `.bag` and gzipped.
 *
 * @property stem what is left without [ending].
 * @property ending that of a log, with its dot and in its own case; empty when there is none.
 * @property isGzip whether `.gz` stands behind it.
 */
internal class FileName private constructor(val stem: String, val ending: String, val isGzip: Boolean) {
    /** The same name with [mark] before its ending. */
    fun marked(mark: String): String = "$stem.$mark$ending${if (isGzip) GZIP else ""}"

    /** The same name, or where that is not free, one with the first number before its ending that is. */
    fun free(isFree: (String) -> Boolean): String = freeName(stem, ending + if (isGzip) GZIP else "", isFree)

    /** The same name with another ending. */
    fun with(ending: String, isGzip: Boolean = this.isGzip): String = "$stem$ending${if (isGzip) GZIP else ""}"

    /** The name of a file of the same log in another format, whose ending is [ending]. */
    fun like(ending: String): FileName = FileName(stem, ending, isGzip)

    /** The same name, without the end of its stem where it is longer than file systems take. */
    fun fitting(): FileName {
        // What is not a log has another ending, such as that of a page.
        val other = "." + stem.substringAfterLast('.', "")
        if (other.length == 1 || other.length > MAX_ENDING || stem.encodeToByteArray().size <= MAX_BYTES) {
            return FileName(startOfBytes(stem, MAX_BYTES), ending, isGzip)
        }
        return FileName(startOfBytes(stem.removeSuffix(other), MAX_BYTES) + other, ending, isGzip)
    }

    override fun toString(): String = with(ending)

    companion object {
        /** File systems allow 255 in all, of which endings and numbers need some. */
        private const val MAX_BYTES = 220
        private const val MAX_ENDING = 6
        private const val GZIP = ".gz"

        /** The name of [path]. */
        fun of(path: Path): FileName = LogName.of(path.fileName.toString()).run { FileName(stem, ending, isGzip) }
    }
}
