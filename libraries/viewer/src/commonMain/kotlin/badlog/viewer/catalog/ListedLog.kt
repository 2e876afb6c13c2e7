package badlog.viewer.catalog

/** A log of a folder, as lists show it. */
interface ListedLog {
    /** The path of the file, with the names of its folders. */
    val path: String

    /** The file's name without its folders. */
    val fileName: String

    /** The size of the file in bytes. */
    val size: Long

    /** The time when the file was last written, in ms since 1970. */
    val modified: Long

    /** The content of the log. */
    val summary: LogSummary

    /** The findings of the rules; null until the rules have run. */
    val found: FindingSummary?

    /** The displayed name: the match if known, otherwise the name of the file. */
    val title: String get() = summary.match.match ?: fileName

    /** Whether the log can be opened. */
    val isReadable: Boolean get() = summary.trouble == null

    /** Whether the log has nothing to see. */
    val isGray: Boolean get() = summary.content != Content.SOMETHING

    /** Whether its bytes are here, so that the rules run by themselves. */
    val isHere: Boolean get() = true
}
