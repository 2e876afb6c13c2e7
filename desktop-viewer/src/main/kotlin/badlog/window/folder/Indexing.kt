package badlog.window.folder

import badlog.catalog.examine.ExaminedLog
import badlog.catalog.folder.FolderStore
import badlog.catalog.folder.IndexQueue
import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.LogReading
import badlog.exporter.BADLOG_VERSION
import badlog.files.FolderScan
import badlog.files.LogFile
import badlog.window.task.returnUnusedMemory
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicInteger
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Keeps an index of the logs of [folder]. Lists the folder repeatedly, and reads new or grown files, on all cores.
 *
 * Listing takes about 2 ms for 1,000 files on a local drive. Having the system report changes would cost less, but it reports none on
 * network drives, and late on macOS.
 *
 * @param cache the folder that stores the results of reading; null for none.
 * @param cores the number of files read at once.
 */
internal class Indexing(
    private val folder: Path,
    private val cache: Path?,
    private val cores: Int = Runtime.getRuntime().availableProcessors(),
) {
    // Not the default dispatcher's threads: work that a person waits for must not wait behind a folder of logs.
    private val readers = Dispatchers.IO.limitedParallelism(cores)
    private val store by lazy { FolderStore(folder, cache, BADLOG_VERSION) }
    private val reading by lazy { LogReading(store) }
    private var searching: Job? = null
    private val started = TimeSource.Monotonic.markNow()
    private val running = AtomicInteger()
    private val largeFile = Mutex()
    private var lastLooked: QueueState? = null

    private val updateCount = MutableStateFlow(0)

    /** A number that changes whenever any of the following properties may have changed. */
    val updates: StateFlow<Int> get() = updateCount

    /** The index; replaced once, when reading begins. */
    @Volatile
    var queue = IndexQueue()
        private set

    /** The reason why the folder, or a part of it, cannot be read, as a sentence. Null if there is none. */
    @Volatile
    var trouble: String? = null
        private set

    /** Whether the folder has been listed. */
    @Volatile
    var hasLooked = false
        private set

    /** Lists and reads until cancelled. */
    suspend fun run() = withContext(Dispatchers.IO) {
        queue = IndexQueue { store[it] }
        try {
            coroutineScope { watch() }
        } finally {
            withContext(NonCancellable) { store.save() }
        }
    }

    private suspend fun CoroutineScope.watch() {
        var lastSaved = started.elapsedNow()
        while (true) {
            val began = started.elapsedNow()
            look()
            val lookTook = started.elapsedNow() - began
            repeat(cores - running.get()) { startReader() }
            if (searching?.isActive != true) searching = launch(Dispatchers.IO) { searchAll() }
            delay(maxOf(LOOK_PERIOD, lookTook * REST_PER_LOOK))
            val isQuiet = queue.state().waiting == 0 && searching?.isActive != true
            if (isQuiet || started.elapsedNow() - lastSaved > SAVE_PERIOD) {
                val saveBegan = started.elapsedNow()
                store.save()
                lastSaved = started.elapsedNow() + (started.elapsedNow() - saveBegan) * REST_PER_LOOK
            }
        }
    }

    private fun CoroutineScope.look() {
        try {
            val scan = FolderScan.of(folder) { ensureActive() }
            trouble = scan.unreadable.firstOrNull()?.let { first ->
                val others = if (scan.unreadable.size > 1) " and ${scan.unreadable.size - 1} more folders" else ""
                "$first$others cannot be read: permission denied; change the permissions, or open another folder."
            }
            queue.found(scan.files, started.elapsedNow())
        } catch (e: IOException) {
            trouble = troubleWith(folder, e)
        }
        val isFirst = !hasLooked
        hasLooked = true
        val now = queue.state().let { QueueState(it.changes, it.waiting, trouble) }
        if (isFirst || now != lastLooked) countUpdate()
        lastLooked = now
    }

    private data class QueueState(val changes: Int, val waiting: Int, val trouble: String?)

    private fun countUpdate() = updateCount.update { it + 1 }

    /** Returns the stored results of the rules for the file of [entry]; null if they have not been run. Call it off the window's thread. */
    fun examined(entry: LogEntry): ExaminedLog? = store.examined(entry.source)

    /** Skips the logs that are waiting to be read. */
    fun stopReading() {
        queue.passOverWaiting()
        countUpdate()
    }

    /** Reads the logs that [stopReading] skipped. */
    fun readAll() {
        queue.wantAll()
        countUpdate()
    }

    private fun CoroutineScope.startReader() {
        running.incrementAndGet()
        launch(readers) {
            try {
                while (true) read(queue.take() ?: break)
            } finally {
                running.decrementAndGet()
            }
        }
    }

    private suspend fun CoroutineScope.read(file: LogFile) {
        var isDone = false
        try {
            // Large logs fill much of the memory with their samples, so two of them are not read in parallel.
            if (file.size > LARGE) largeFile.lock()
            val began = started.elapsedNow()
            try {
                val found = reading.read(file, runsRules = isSettled(file), { ensureActive() }) { entry ->
                    isDone = true
                    queue.finished(entry, started.elapsedNow(), started.elapsedNow() - began)
                    countUpdate()
                }
                found.found?.let { queue.searched(found, it) }
            } finally {
                if (file.size > LARGE) leaveLargeFile()
            }
        } finally {
            if (!isDone) queue.abandoned(file)
            countUpdate()
        }
    }

    private fun leaveLargeFile() {
        largeFile.unlock()
        returnUnusedMemory()
    }

    // The rules do not run here over a log that is being written.
    private fun isSettled(file: LogFile) = file.modified < System.currentTimeMillis() - SETTLED.inWholeMilliseconds

    /** Runs the rules over logs without results of the current rules, the newest first. Pauses while a file is waiting to be read. */
    private suspend fun searchAll() = coroutineScope {
        while (true) {
            val state = queue.state()
            val entry = state.entries
                .filter { it.isReadable && !it.isGray && isSettled(it.source) && it.found?.key != store.keyOf(it.file) }
                .maxByOrNull { it.source.modified }
            if (entry == null || state.waiting > 0) break
            if (entry.source.size > LARGE) largeFile.lock()
            val found = try {
                reading.found(entry.source) { ensureActive() }
            } finally {
                if (entry.source.size > LARGE) leaveLargeFile()
            }
            queue.searched(entry, found)
            countUpdate()
        }
    }

    private companion object {
        val LOOK_PERIOD: Duration = 300.milliseconds
        val SAVE_PERIOD: Duration = 4.seconds

        /** The time without a change after which a log counts as complete. */
        val SETTLED: Duration = 3.seconds

        /** The pause after listing or saving, as a multiple of its duration: each takes at most a twentieth of the time. */
        const val REST_PER_LOOK = 20

        const val LARGE = 64L shl 20
    }
}

/** Returns a sentence for the user about [folder], which cannot be read because of [e]. */
internal fun troubleWith(folder: Path, e: IOException): String = when (e) {
    is AccessDeniedException -> "$folder cannot be read: permission denied; change its permissions, or open another folder."
    is NoSuchFileException -> "There is no folder $folder; connect its drive, or open another folder."
    else -> "$folder does not answer; is its drive connected?"
}
