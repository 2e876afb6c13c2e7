package badlog.catalog.folder

import badlog.files.LogFile
import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.LogFound
import badlog.viewer.catalog.LogSummary
import java.nio.file.Path

/**
 * What is known about a file of a folder without reading it again.
 *
 * @property source the file when it was read.
 * @property summary what it holds.
 * @property found what the rules found in it; null while they have not been run.
 */
data class LogEntry(val source: LogFile, override val summary: LogSummary, override val found: LogFound? = null) : ListedLog {
    /** The file; absolute. */
    val file: Path get() = source.path

    override val path: String get() = file.toString()

    override val fileName: String get() = source.name

    override val size: Long get() = source.size

    override val modified: Long get() = source.modified
}
