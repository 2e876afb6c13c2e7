package badlog.viewer.catalog

/** A log of a folder, as lists show it. */
interface ListedLog {
    /** Its place, with the names of its folders. */
    val path: String

    /** The file's name without its folders. */
    val fileName: String

    /** The size of its file in bytes. */
    val size: Long

    /** When the file was last written, in ms since 1970. */
    val modified: Long

    /** What it holds. */
    val summary: LogSummary

    /** What the rules found in it; null while they have not been run. */
    val found: LogFound?

    /** Its name for people: the match, or else the name of the file. */
    val title: String get() = summary.match.match ?: fileName

    /** Whether it can be opened. */
    val isReadable: Boolean get() = summary.trouble == null

    /** Whether there is nothing to see in it. */
    val isGray: Boolean get() = summary.content != Content.SOMETHING
}
