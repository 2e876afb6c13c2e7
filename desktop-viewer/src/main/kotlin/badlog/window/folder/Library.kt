package badlog.window.folder

import badlog.catalog.examine.ExaminedLog
import badlog.catalog.folder.IndexQueue
import badlog.catalog.folder.LogEntry
import badlog.window.settings.SettingsStore
import badlog.window.state.StateHolder
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.nio.file.Path
import kotlin.time.Duration.Companion.milliseconds

/**
 * The folder of logs, kept up to date with the disk. Use it only on the window's thread.
 *
 * @param scope the scope for reading the folder; its thread is the window's.
 * @param cache the folder for cached indexes.
 * @param settings remembers which folders were opened.
 */
internal class Library(private val scope: CoroutineScope, private val cache: Path, private val settings: SettingsStore) :
    StateHolder<LibraryState>(LibraryState()) {
    private var job: Job? = null
    private var indexing: Indexing? = null
    private val mutableProgress = MutableStateFlow<IndexProgress?>(null)

    /**
     * The progress of reading the folder, as of [state]. It is null until the folder is listed, or if its newest log is not to be shown.
     */
    val progress: StateFlow<IndexProgress?> get() = mutableProgress

    /**
     * Shows the logs of [folder] and its subfolders from now on.
     *
     * @param showsNewest whether its newest log is shown until a person opens another one.
     */
    fun open(folder: Path, showsNewest: Boolean = true) {
        val path = folder.toAbsolutePath().normalize()
        val before = job
        val isSame = state.folder == path
        close()
        change { opening(path) }
        settings.change { opened(path.toString()) }
        val started = Indexing(path, cache)
        indexing = started
        job = scope.launch {
            // The cache of a folder must be completely written before the same folder is opened again.
            if (isSame) before?.join()
            launch { started.run() }
            publish(started, showsNewest)
        }
    }

    /** Closes the folder; its index is kept for the next time. */
    fun close() {
        job?.cancel()
        job = null
        indexing = null
        mutableProgress.value = null
    }

    /** Skips the logs that are waiting to be read. */
    fun stopReading() {
        indexing?.stopReading()
    }

    /** Reads the logs that [stopReading] skipped. */
    fun readAll() {
        indexing?.readAll()
    }

    /**
     * A function that returns the rules' stored results for a log of the open folder. Null if they have not been run. Call it off the
     * window's thread.
     */
    val examined: (LogEntry) -> ExaminedLog?
        get() {
            val opened = indexing
            return { opened?.examined(it) }
        }

    fun select(file: Path) = change { copy(selected = file) }

    private suspend fun publish(indexing: Indexing, showsNewest: Boolean) {
        var shownQueue: IndexQueue? = null
        var shownChanges = -1
        indexing.updates.collect {
            val hasLooked = indexing.hasLooked
            val queue = indexing.queue
            val index = withContext(Dispatchers.Default) { queue.state() }
            var library = state.copy(
                hasLooked = hasLooked,
                trouble = indexing.trouble,
                files = index.files,
                passedOver = index.passedOver,
                reading = if (index.waiting > 0) ReadingProgress(index.read, index.read + index.waiting) else null,
            )
            if (queue !== shownQueue || index.changes != shownChanges) library = library.withEntries(index.entries)
            shownQueue = queue
            shownChanges = index.changes
            if (library != state) change { library }
            if (hasLooked && showsNewest) mutableProgress.value = IndexProgress(queue, index.waiting == 0)
            // Sorting many logs again takes time that the window needs for other things.
            delay(if (index.entries.size > LARGE_FOLDER) PERIOD * 5 else PERIOD)
        }
    }

    private companion object {
        val PERIOD = 100.milliseconds
        const val LARGE_FOLDER = 2000
    }
}

/** The progress of reading a folder: the index [queue], and whether it is complete. Compared by identity. */
internal class IndexProgress(val queue: IndexQueue, val isComplete: Boolean)
