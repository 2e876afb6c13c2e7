package badlog.file

/**
 * The parts of a log's name: `match.bag.gz` is `match`, `.bag` and gzipped. What a file holds, only its content tells.
 *
 * @property stem what is left without [ending].
 * @property ending that of a log, with its dot and in its own case; empty when there is none.
 * @property isGzip whether `.gz` stands behind it.
 */
public class LogName private constructor(public val stem: String, public val ending: String, public val isGzip: Boolean) {
    /** Whether a log may be called so. */
    public val mayBeLog: Boolean get() = ending.isNotEmpty() || isGzip

    /** Whether only logs are called so; tables of all kinds end in `.csv`. */
    public val isOnlyOfLogs: Boolean get() = ending.isNotEmpty() && ending.lowercase() != CSV

    public companion object {
        private const val GZIP = ".gz"
        private const val CSV = ".csv"
        internal const val DSLOG = ".dslog"
        internal const val DSEVENTS = ".dsevents"
        internal const val HOOT = ".hoot"

        /** What logs of REV's motor controllers end in. */
        public const val REVLOG: String = ".revlog"
        private val ENDINGS = listOf(".bag", ".badbag", CSV, ".wpilog", ".wpilogxz", REVLOG, HOOT, DSLOG, DSEVENTS)

        /** The parts of [name], which is without folders. */
        public fun of(name: String): LogName {
            val isGzip = name.endsWith(GZIP, ignoreCase = true) && name.length > GZIP.length
            val inner = if (isGzip) name.dropLast(GZIP.length) else name
            val ending = ENDINGS.find { inner.endsWith(it, ignoreCase = true) && inner.length > it.length }.orEmpty()
            return LogName(inner.dropLast(ending.length), inner.takeLast(ending.length), isGzip)
        }
    }
}
