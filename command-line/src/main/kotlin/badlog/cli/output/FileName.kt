package badlog.cli.output

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

    /** The same name with ` (2)` or another [number] before its ending. */
    fun numbered(number: Int): String = "$stem ($number)$ending${if (isGzip) GZIP else ""}"

    /** The same name with another ending. */
    fun with(ending: String, isGzip: Boolean = this.isGzip): String = "$stem$ending${if (isGzip) GZIP else ""}"

    companion object {
        private const val GZIP = ".gz"
        private val ENDINGS = listOf(".bag", ".badbag", ".csv", ".wpilog")

        /** The name of [path]. */
        fun of(path: Path): FileName {
            val name = path.fileName.toString()
            val isGzip = name.endsWith(GZIP, ignoreCase = true) && name.length > GZIP.length
            val inner = if (isGzip) name.dropLast(GZIP.length) else name
            val ending = ENDINGS.find { inner.endsWith(it, ignoreCase = true) && inner.length > it.length }.orEmpty()
            return FileName(inner.dropLast(ending.length), inner.takeLast(ending.length), isGzip)
        }
    }
}
