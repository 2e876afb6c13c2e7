package badlog.window.folder

import badlog.catalog.folder.LogEntry
import badlog.files.LogFile
import badlog.files.LogName
import badlog.viewer.shown.folder.Listing
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.shown.folder.logsOfRobots
import java.nio.file.Path

/**
 * The folder of logs as the window shows it. Immutable; each transition returns a new one.
 *
 * @property folder the folder; null before one was opened.
 * @property listing its logs, sorted and filtered.
 * @property files the files in the folder, whether or not anything is known about them.
 * @property reading the progress of reading them; null while there is nothing to read.
 * @property passedOver the number of logs skipped because a person stopped reading.
 * @property hasLooked whether the files have been listed.
 * @property trouble the reason why the folder or a part of it cannot be read, as a sentence; null if all is well.
 * @property selected the file selected with the keyboard.
 * @property isSearchAsked whether the search field gets the keyboard focus as soon as it is visible.
 */
internal data class LibraryState(
    val folder: Path? = null,
    val listing: Listing<LogEntry> = Listing(),
    val files: List<LogFile> = emptyList(),
    val reading: ReadingProgress? = null,
    val passedOver: Int = 0,
    val hasLooked: Boolean = false,
    val trouble: String? = null,
    val selected: Path? = null,
    val isSearchAsked: Boolean = false,
) {
    /** All known logs of the folder, in no particular order, including unlisted ones. */
    val entries: List<LogEntry> get() = listing.entries

    /** The listed logs, in order. */
    val visible: List<LogEntry> get() = listing.visible

    /** The readable logs of robots, in no particular order. */
    val ofRobots: List<LogEntry> get() = logsOfRobots(entries) { LogName.of(it).isOnlyOfLogs }

    /** The latest log of a robot by its date, if possible one that is not idle. Null if there are none. */
    val newest: LogEntry? get() = ofRobots.filter { !it.isGray }.maxWithOrNull(AGE) ?: ofRobots.maxWithOrNull(AGE)

    /** Whether there is certainly no log to show. Either no folder is open, or the open one has been read and has no logs. */
    val isWithoutLogs: Boolean get() = folder == null || (hasLooked && reading == null && listing.size == 0)

    /** Returns the state for another [folder], still without logs, listed like this one but unfiltered. */
    fun opening(folder: Path): LibraryState = LibraryState(
        folder,
        listing.copy(entries = emptyList(), filter = "", onlyErrors = false, folder = "$folder", recording = emptySet()),
    )

    /** Returns the same folder with [entries]. A log that grows is being recorded, until the rules have run over it, if they ever do. */
    fun withEntries(entries: List<LogEntry>): LibraryState {
        val before = listing.entries.associate { it.path to it.size }
        val recording = entries.filter {
            it.found == null && ((it.path in listing.recording && !it.isGray) || (before[it.path] ?: it.size) < it.size)
        }
        return copy(listing = listing.copy(entries = entries, recording = recording.mapTo(HashSet()) { it.path }))
    }

    /** Lists only logs with all words of [filter]. */
    fun filtered(filter: String): LibraryState = copy(listing = listing.copy(filter = filter))

    /** Sorts by [column], or reverses the order if that is the column already. */
    fun sorted(column: LogColumn): LibraryState = copy(listing = listing.sorted(column))

    /** Hides or shows gray logs. */
    fun hidingEmpty(hides: Boolean): LibraryState = copy(listing = listing.copy(hidesEmpty = hides))

    /** Hides or shows logs in which no rule found an error. */
    fun onlyErrors(isOn: Boolean): LibraryState = copy(listing = listing.copy(onlyErrors = isOn))

    /** The key of the row with the selected log; null if it is not listed. */
    val selectedRow: String? get() = rowOf(selected)

    /** Returns the key of the row with the log in [file]; null if it is not listed. */
    fun rowOf(file: Path?): String? = listing.rows.find { row -> row.logs.any { it.file == file } }?.worst?.path

    /** Returns the log [steps] rows below the selected one in the list; the first or last if the list ends. */
    fun stepped(steps: Int): LogEntry? {
        val rows = listing.rows
        if (rows.isEmpty()) return null
        val selected = selectedRow
        val at = rows.indexOfFirst { it.worst.path == selected }
        return rows[if (at < 0) (if (steps > 0) 0 else rows.lastIndex) else (at + steps).coerceIn(rows.indices)].worst
    }

    private companion object {
        val AGE: Comparator<LogEntry> = compareBy({ it.summary.date.second }, { it.source.modified })
    }
}

/** The progress of reading: [read] of [total] logs. */
internal data class ReadingProgress(val read: Int, val total: Int)
