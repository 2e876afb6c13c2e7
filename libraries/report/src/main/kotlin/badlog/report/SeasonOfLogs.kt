package badlog.report

import badlog.catalog.folder.FolderBatteries
import badlog.catalog.folder.FolderStore
import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.LogReading
import badlog.exporter.BADLOG_VERSION
import badlog.files.FolderRun
import badlog.files.LogFile
import badlog.files.withShutdownHook
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.shown.battery.BatterySeason
import java.nio.file.Files
import java.nio.file.Path

/**
 * The batteries in many logs.
 *
 * @property seasons the data of each battery.
 * @property entries the logs, in the given order.
 * @property problems the reasons why files about batteries are not used, as sentences.
 */
class SeasonOfLogs private constructor(val seasons: List<BatterySeason>, val entries: List<LogEntry>, val problems: List<String>) {
    /** Whether a log, or the team, names a battery. */
    val hasNames: Boolean get() = seasons.any { it.battery != null }

    companion object {
        internal val NONE = SeasonOfLogs(emptyList(), emptyList(), emptyList())

        /**
         * Reads [files] on all cores, except for files with cached results.
         *
         * @param folders the folders in which they were found; files of batteries are searched for up to their common folder.
         * @param cache a folder for cached results, shared with the window; null for none.
         * @param progress called on this thread with the number of files done.
         */
        fun over(
            files: List<LogFile>,
            folders: List<Path>,
            cache: Path?,
            progress: (done: Int, total: Int) -> Unit = { _, _ -> },
        ): SeasonOfLogs {
            val folder = commonFolderOf(files, folders) ?: return NONE
            val store = FolderStore(folder, cache, BADLOG_VERSION)
            val reading = LogReading(store)
            val entries = ArrayList<LogEntry>()
            val advance = { progress(entries.size, files.size) }
            try {
                withShutdownHook(store::save) {
                    FolderRun().forEach(files, { file, _ -> store[file] ?: reading.read(file, runsRules = false) }, advance) { _, entry ->
                        entries += entry
                        advance()
                    }
                }
            } finally {
                store.save()
            }
            return of(entries, folder)
        }

        /** Returns the batteries in the logs of a report. */
        internal fun of(logs: List<LogReport>): SeasonOfLogs {
            val folder = commonFolderOf(logs.map { it.file }) ?: return NONE
            return of(logs.filter { it.unreadable == null }.map(::entryOf), folder)
        }

        private fun of(entries: List<LogEntry>, folder: Path): SeasonOfLogs {
            val written = FolderBatteries.of(entries.map { it.file }, folder)
            val seasons = BatterySeason.of(entries, written.batteries) { logs ->
                written.usedFor(logs.map { it.file }, logs.firstNotNullOfOrNull { it.summary.match.match })
            }
            return SeasonOfLogs(seasons, entries, written.problems)
        }

        private fun entryOf(log: LogReport): LogEntry {
            val date = log.began?.let { LogDate(it, DateSource.VALUES) } ?: LogDate.of(emptyList(), log.file.name, log.file.modified)
            return LogEntry(log.file, LogSummary(log.match, date, content = Content.SOMETHING, battery = log.battery))
        }
    }
}

/** Returns the lowest folder that contains all [files] and [folders], or is one of the folders; null if there are neither. */
internal fun commonFolderOf(files: List<LogFile>, folders: List<Path> = emptyList()): Path? =
    (files.map { it.path.toAbsolutePath().normalize().parent } + folders.map { it.toAbsolutePath().normalize() }.filter(Files::isDirectory))
        .reduceOrNull { one, other -> generateSequence(one) { it.parent }.firstOrNull(other::startsWith) ?: one.root }
