package badlog.page.opened

import badlog.formats.LOG_ENDINGS
import badlog.formats.driverstation.DriverStationFormat.FIRST_ENDING
import badlog.formats.driverstation.DriverStationFormat.SECOND_ENDING
import badlog.page.dom.place
import badlog.page.embedded.LogBytes
import badlog.page.embedded.markupOf
import badlog.page.served.ServedFile
import badlog.page.served.served
import badlog.rules.number.LogNumbers
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.LogSummary
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * A log that a person opened, which stays on the person's computer, or a log on the page's server.
 *
 * @property files its file, or both files of a Driver Station log, in the order in which they are read; empty files for a log on the
 * server.
 * @property summary the known facts about it: at first, those in its name.
 * @property numbers the numbers to compare with other logs.
 * @property origin its place on the page's server; null if it was opened from this device.
 */
internal class OpenedLog(
    val files: List<File>,
    override val summary: LogSummary = LogSummary.named(files[0].name, modifiedOf(files[0])),
    override val found: FindingSummary? = null,
    val numbers: LogNumbers = LogNumbers.NONE,
    val origin: ServedFile? = files[0].served,
) : ListedLog {
    // Stored, because asking the browser costs more, and lists of logs ask often.
    override val path: String = pathOf(files[0])

    override val fileName: String get() = files[0].name

    override val size: Long get() = files.sumOf { it.served?.size ?: it.size.toDouble() }.toLong()

    override val isHere: Boolean get() = files.none { it.served != null }

    override val modified: Long = modifiedOf(files[0])

    /** The log's key in the browser's storage. A log on a server keeps its key when it grows. */
    val key: String get() = if (origin != null) path else "$fileName:${files.sumOf { it.size.toDouble() }}"

    /** Returns this log with more facts about it. */
    fun with(summary: LogSummary, found: FindingSummary?, numbers: LogNumbers = LogNumbers.NONE): OpenedLog =
        OpenedLog(files, summary, found, numbers, origin)

    /** Returns this log with [file], its file after it has grown. */
    fun growing(file: File): OpenedLog = OpenedLog(listOf(file), summary, found, numbers, origin)

    /** Returns this log with the files in [fetched] in place of the empty ones. */
    fun with(fetched: Map<File, File>): OpenedLog = OpenedLog(files.map { fetched[it] ?: it }, summary, found, numbers, origin)

    /** Returns the log's bytes, on a page made by badlog [version]. */
    fun bytes(version: String): LogBytes = object : LogBytes {
        override fun original() = Promise.resolve(Blob(files.toTypedArray()))

        override fun text(filter: (ByteArray) -> ByteArray) = null

        override fun toMarkup() = markupOf(files, version)
    }

    companion object {
        /** Returns the logs in [files], in order; some files may not be logs. */
        fun logsIn(files: List<File>): List<OpenedLog> {
            // Files from different places may have the same name.
            for (same in files.groupBy(::pathOf).values) {
                same.drop(1).forEachIndexed { i, file -> file.place = "${pathOf(file)} (${i + 2})" }
            }
            val seconds = files.filter { it.name.endsWith(SECOND_ENDING, ignoreCase = true) }.associateByTo(HashMap(), ::withoutEnding)
            val logs = files.filterNot { it.name.endsWith(SECOND_ENDING, ignoreCase = true) }.map { first ->
                val second = if (first.name.endsWith(FIRST_ENDING, ignoreCase = true)) seconds.remove(withoutEnding(first)) else null
                OpenedLog(listOfNotNull(first, second))
            }
            return logs + seconds.values.map { OpenedLog(listOf(it)) }
        }

        /** Returns whether [file] has the name of a log. */
        fun isNamedLikeLog(file: File): Boolean = isNamedLikeLog(pathOf(file))

        /** Returns whether the file at [path] has the name of a log. */
        fun isNamedLikeLog(path: String): Boolean {
            val name = path.removeSuffix(".gz").lowercase()
            // Systems keep their own data in files and folders with such names.
            val isHidden = path.split('/').any { it.startsWith('.') || it.startsWith('$') }
            return !isHidden && LOG_ENDINGS.any(name::endsWith)
        }

        /** Returns whether names like [name] belong only to logs; tables of all kinds end in `.csv`. */
        fun isOnlyOfLogs(name: String): Boolean = !name.removeSuffix(".gz").endsWith(".csv", ignoreCase = true)

        /** Returns the time at which [file] was last written, in ms since 1970. */
        fun modifiedOf(file: File): Long = (file.asDynamic().lastModified as Double).toLong()

        /** Returns the path of [file]; a file that was dropped alone has no folder. */
        fun pathOf(file: File): String = file.place ?: (file.asDynamic().webkitRelativePath as String?).orEmpty().ifEmpty { file.name }

        // Two folders may have files of the same name.
        private fun withoutEnding(file: File) = pathOf(file).substringBeforeLast('.')
    }
}

/** Returns whether the file called [name] is a page, which may hold a log. */
internal fun isPage(name: String): Boolean = name.endsWith(".html", ignoreCase = true) || name.endsWith(".htm", ignoreCase = true)
