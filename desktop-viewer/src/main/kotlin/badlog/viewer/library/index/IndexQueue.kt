package badlog.viewer.library.index

import badlog.file.LogFile
import badlog.file.LogName
import java.nio.file.Path
import java.util.TreeSet
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * What is known of a folder's logs, and which of them are to be read next: the newest first. Time is what the caller says it
 * is, counted from anywhere. May be used by several threads at once.
 *
 * @param cached what was known before.
 */
internal class IndexQueue(cached: Collection<LogEntry> = emptyList()) {
    private val remembered = cached.associateByTo(HashMap()) { it.file }
    private val known = HashMap<Path, LogEntry>()
    private val notBefore = HashMap<Path, Duration>()
    private val busy = HashSet<Path>()
    private val passedOver = HashSet<LogFile>()
    private var present = emptyMap<Path, LogFile>()
    private var waiting = TreeSet(NEWEST_FIRST)
    private var read = 0
    private var changes = 0

    /** Takes in that [files] are what is in the folder at [now]. */
    @Synchronized
    fun found(files: List<LogFile>, now: Duration) {
        present = files.associateBy { it.path }
        if (known.keys.retainAll(present.keys)) changes++
        notBefore.keys.retainAll(present.keys)
        passedOver.retainAll { present[it.path] == it }
        for (file in files) {
            val entry = remembered[file.path]
            if (file.path !in known && entry?.source == file) {
                known[file.path] = entry
                changes++
            }
        }
        // Only the first look finds what was known before; later ones know it themselves.
        remembered.clear()
        waiting = files.filterTo(TreeSet(NEWEST_FIRST)) { isToRead(it, now) }
    }

    private fun isToRead(file: LogFile, now: Duration) = known[file.path]?.source != file && file.path !in busy &&
        file !in passedOver && now >= (notBefore[file.path] ?: Duration.ZERO)

    /** Takes out the file that is to be read next; null when there is none. [finished] or [abandoned] must follow. */
    @Synchronized
    fun take(): LogFile? = waiting.pollFirst()?.also { busy.add(it.path) }

    /** Takes in what was read of a file, at [now] and in [took]. */
    @Synchronized
    fun finished(entry: LogEntry, now: Duration, took: Duration) {
        busy.remove(entry.file)
        read++
        if (entry.file !in present) return
        known[entry.file] = entry
        // A log that is being written is read again and again, but must not keep the machine busy.
        notBefore[entry.file] = now + maxOf(MIN_REST, took * REST_PER_READING)
        changes++
    }

    /** Takes in what the rules [found] in the file of [entry], unless that has changed meanwhile. */
    @Synchronized
    fun searched(entry: LogEntry, found: LogFound) {
        val now = known[entry.file] ?: return
        if (now.source != entry.source) return
        known[entry.file] = now.copy(found = found)
        changes++
    }

    /** Says that reading [file] was given up. */
    @Synchronized
    fun abandoned(file: LogFile) {
        busy.remove(file.path)
    }

    /** Reads none of the files that wait now, until they change. */
    @Synchronized
    fun passOverWaiting() {
        passedOver += waiting
        waiting = TreeSet(NEWEST_FIRST)
        changes++
    }

    /** Reads what was passed over after all, from the next look on. */
    @Synchronized
    fun wantAll() {
        passedOver.clear()
        changes++
    }

    /** Returns how things stand. */
    @Synchronized
    fun state() = IndexState(
        entries = known.values.toList(),
        read = read,
        waiting = waiting.size + busy.size,
        passedOver = passedOver.size,
        changes = changes,
    ).also { if (it.waiting == 0) read = 0 }

    /**
     * Returns what is known of the newest files, up to the first that is not known yet; the newest first. Where there are files
     * that can only be logs, only of those.
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
 * How the index of a folder stands.
 *
 * @property entries all that is known, in no order.
 * @property read how many files were read since there last was nothing to read.
 * @property waiting how many are being read, or will be.
 * @property passedOver how many a person does not want to be read now.
 * @property changes another number whenever [entries] or [passedOver] have changed.
 */
internal class IndexState(val entries: List<LogEntry>, val read: Int, val waiting: Int, val passedOver: Int, val changes: Int)
