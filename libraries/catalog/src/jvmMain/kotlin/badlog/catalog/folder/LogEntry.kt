package badlog.catalog.folder

import badlog.catalog.Content
import badlog.catalog.LogFound
import badlog.catalog.LogSummary
import badlog.files.LogFile
import java.nio.file.Path

/**
 * What is known about a file of a folder without reading it again.
 *
 * @property source the file when it was read.
 * @property summary what it holds.
 * @property found what the rules found in it; null while they have not been run.
 */
data class LogEntry(val source: LogFile, val summary: LogSummary, val found: LogFound? = null) {
    /** The file; absolute. */
    val file: Path get() = source.path

    /** The file's name without its folders. */
    val fileName: String get() = source.name

    /** Its name for people: the match, or else the name of the file. */
    val title: String get() = summary.match.match ?: fileName

    /** Whether it can be opened. */
    val isReadable: Boolean get() = summary.trouble == null

    /** Whether there is nothing to see in it. */
    val isGray: Boolean get() = summary.content != Content.SOMETHING
}
