package badlog.catalog.folder

import badlog.files.LogFile
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.LogSummary
import java.nio.file.Path

/**
 * The known results for a file of a folder.
 *
 * @property source the state of the file when it was read.
 * @property summary the summary of its content.
 * @property found the findings of the rules; null until they have been run.
 */
data class LogEntry(val source: LogFile, override val summary: LogSummary, override val found: FindingSummary? = null) : ListedLog {
    /** The file; absolute. */
    val file: Path get() = source.path

    override val path: String get() = file.toString()

    override val fileName: String get() = source.name

    override val size: Long get() = source.size

    override val modified: Long get() = source.modified
}
