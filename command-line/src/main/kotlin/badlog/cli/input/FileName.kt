package badlog.cli.input

import badlog.core.text.freeName
import badlog.files.LogName
import badlog.report.startOfBytes
import java.nio.file.Path

/**
 * The parts of a log's name: `match.bag.gz` is `match`, `.bag` and gzipped.
 *
 * @property stem the name without [ending] and `.gz`.
 * @property ending the ending of a log, with its dot and in its original case; empty if there is none.
 * @property isGzip whether `.gz` follows.
 */
internal class FileName private constructor(val stem: String, val ending: String, val isGzip: Boolean) {
    /** Returns the same name with [mark] before its ending. */
    fun marked(mark: String): String = "$stem.$mark$ending${if (isGzip) GZIP else ""}"

    /** Returns the same name, or, if that is taken, one with the first free number before its ending. */
    fun free(isFree: (String) -> Boolean): String = freeName(stem, ending + if (isGzip) GZIP else "", isFree)

    /** Returns the same name with another ending. */
    fun with(ending: String, isGzip: Boolean = this.isGzip): String = "$stem$ending${if (isGzip) GZIP else ""}"

    /** Returns the name of a file of the same log in another format with [ending]. */
    fun like(ending: String): FileName = FileName(stem, ending, isGzip)

    /** Returns the same name, with its stem shortened if it is too long for file systems. */
    fun fitting(): FileName {
        // A file that is not a log has another ending, such as `.html`.
        val other = "." + stem.substringAfterLast('.', "")
        if (other.length == 1 || other.length > MAX_ENDING || stem.encodeToByteArray().size <= MAX_BYTES) {
            return FileName(startOfBytes(stem, MAX_BYTES), ending, isGzip)
        }
        return FileName(startOfBytes(stem.removeSuffix(other), MAX_BYTES) + other, ending, isGzip)
    }

    override fun toString(): String = with(ending)

    companion object {
        /** File systems allow 255 in total; endings and numbers need some of them. */
        private const val MAX_BYTES = 220
        private const val MAX_ENDING = 6
        private const val GZIP = ".gz"

        /** Returns the name of [path]. */
        fun of(path: Path): FileName = LogName.of(path.fileName.toString()).run { FileName(stem, ending, isGzip) }
    }
}
