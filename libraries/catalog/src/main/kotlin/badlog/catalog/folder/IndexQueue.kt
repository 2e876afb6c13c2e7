package badlog.catalog.folder

import badlog.files.LogFile
import badlog.files.LogName
import badlog.viewer.catalog.FindingSummary
import java.nio.file.Path
import java.util.TreeSet
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * The known results of a folder's logs, and the queue of files to read next, the newest first. The caller provides the time, with an
 * arbitrary origin. Thread-safe.
 *
 * @param stored returns the stored results for a file in its current state; null if there are none.
 */
class IndexQueue(private val stored: (LogFile) -> LogEntry? = { null }) {
    private val known = HashMap<Path, LogEntry>()
    private val notBefore = HashMap<Path, Duration>()
    private val busy = HashSet<Path>()
    private val passedOver = HashSet<LogFile>()
    private var present = emptyMap<Path, LogFile>()
    private var waiting = TreeSet(NEWEST_FIRST)
    private var read = 0
    private var changes = 0

    /** Updates the queue to [files], the content of the folder at [now]. */
    @Synchronized
    fun found(files: List<LogFile>, now: Duration) {
        present = files.associateBy { it.path }
        if (known.keys.retainAll(present.keys)) changes++
        notBefore.keys.retainAll(present.keys)
        passedOver.retainAll { present[it.path] == it }
        for (file in files) {
            if (known[file.path]?.source == file || file.path in busy) continue
            known[file.path] = stored(file) ?: continue
            changes++
        }
        waiting = files.filterTo(TreeSet(NEWEST_FIRST)) { isToRead(it, now) }
    }

    private fun isToRead(file: LogFile, now: Duration) = known[file.path]?.source != file && file.path !in busy &&
        file !in passedOver && now >= (notBefore[file.path] ?: Duration.ZERO)

    /** Removes and returns the next file to read; null if there is none. Call [finished] or [abandoned] afterwards. */
    @Synchronized
    fun take(): LogFile? = waiting.pollFirst()?.also { busy.add(it.path) }

    /** Adds the result of reading a file, which ended at [now] and took [took]. */
    @Synchronized
    fun finished(entry: LogEntry, now: Duration, took: Duration) {
        busy.remove(entry.file)
        read++
        if (entry.file !in present) return
        known[entry.file] = entry
        // A log that is being written is read repeatedly, but must not keep the machine busy.
        notBefore[entry.file] = now + maxOf(MIN_REST, took * REST_PER_READING)
        changes++
    }

    /** Adds [found], the findings of the rules in the file of [entry], unless the file has changed in the meantime. */
    @Synchronized
    fun searched(entry: LogEntry, found: FindingSummary) {
        val now = known[entry.file] ?: return
        if (now.source != entry.source) return
        known[entry.file] = now.copy(found = found)
        changes++
    }

    /** Records that reading [file] was cancelled. */
    @Synchronized
    fun abandoned(file: LogFile) {
        busy.remove(file.path)
    }

    /** Skips all files that are currently waiting, until they change. */
    @Synchronized
    fun passOverWaiting() {
        passedOver += waiting
        waiting = TreeSet(NEWEST_FIRST)
        changes++
    }

    /** Queues the skipped files again at the next update. */
    @Synchronized
    fun wantAll() {
        passedOver.clear()
        changes++
    }

    @Synchronized
    fun state() = IndexState(
        entries = known.values.toList(),
        files = present.values.toList(),
        read = read,
        waiting = waiting.size + busy.size,
        passedOver = passedOver.size,
        changes = changes,
    ).also { if (it.waiting == 0) read = 0 }

    /**
     * Returns the known results of the newest files, newest first, up to the first unknown file. Files with names that other files may have
     * too, such as `.csv`, are included only if there are no others.
     */
    @Synchronized
    fun newestKnown(): List<LogEntry> {
        val files = present.values.filter { LogName.of(it.name).isOnlyOfLogs }.ifEmpty { present.values }
        return files.sortedWith(NEWEST_FIRST).takeWhile { it.path in known }.mapNotNull { known[it.path] }
    }

    private companion object {
        val MIN_REST = 0.9.seconds
        const val REST_PER_READING = 10

        val NEWEST_FIRST: Comparator<LogFile> =
            compareByDescending<LogFile> { it.modified }.thenByDescending { it.name }.thenBy { it.path }
    }
}

/**
 * The state of a folder's index.
 *
 * @property entries all known results, in no particular order.
 * @property files the files in the folder, read or not.
 * @property read the number of files read since the queue was last empty.
 * @property waiting the number of files being read, or waiting.
 * @property passedOver the number of files skipped at the person's request.
 * @property changes a number that changes whenever [entries] or [passedOver] change.
 */
class IndexState(
    val entries: List<LogEntry>,
    val files: List<LogFile>,
    val read: Int,
    val waiting: Int,
    val passedOver: Int,
    val changes: Int,
)
