package badlog.files

import badlog.formats.LOG_ENDINGS

/**
 * The parts of a log's name: `match.bag.gz` is `match`, `.bag` and gzipped. Only the content shows the real format.
 *
 * @property stem the name without [ending] and `.gz`.
 * @property ending the ending of a log, with its dot and in its original case; empty if there is none.
 * @property isGzip whether `.gz` follows.
 */
public class LogName private constructor(public val stem: String, public val ending: String, public val isGzip: Boolean) {
    /** Whether it may be the name of a log. */
    public val mayBeLog: Boolean get() = ending.isNotEmpty() || isGzip

    /** Whether only logs have such names; tables of all kinds end in `.csv`. */
    public val isOnlyOfLogs: Boolean get() = ending.isNotEmpty() && ending.lowercase() != CSV

    public companion object {
        private const val GZIP = ".gz"
        private const val CSV = ".csv"
        internal const val HOOT = ".hoot"

        /** The endings of logs that can be read, or be made readable, here; `.gz` may follow. */
        public val ENDINGS: List<String> = LOG_ENDINGS + listOf(".wpilogxz", HOOT)

        /** Returns the parts of [name], which must not include folders. */
        public fun of(name: String): LogName {
            val isGzip = name.endsWith(GZIP, ignoreCase = true) && name.length > GZIP.length
            val inner = if (isGzip) name.dropLast(GZIP.length) else name
            val ending = ENDINGS.find { inner.endsWith(it, ignoreCase = true) && inner.length > it.length }.orEmpty()
            return LogName(inner.dropLast(ending.length), inner.takeLast(ending.length), isGzip)
        }
    }
}
