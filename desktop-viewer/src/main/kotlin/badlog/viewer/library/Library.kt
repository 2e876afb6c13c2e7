package badlog.viewer.library

import badlog.viewer.app.NewestShowing
import badlog.viewer.app.Viewer
import badlog.viewer.library.index.IndexCache
import badlog.viewer.library.index.IndexQueue
import badlog.viewer.library.index.Indexing
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.nio.file.Path
import kotlin.time.Duration.Companion.milliseconds

/** Keeps the window's library as its folder is. To be used on the window's thread only. */
internal class LibraryFolder(private val viewer: Viewer) {
    private var job: Job? = null
    private var indexing: Indexing? = null
    private val newest = NewestShowing(viewer)

    /**
     * Shows the logs of [folder] and its sub-folders from now on.
     *
     * @param showsNewest whether its newest log is shown while nobody has opened another.
     */
    fun open(folder: Path, showsNewest: Boolean = true) {
        val path = folder.toAbsolutePath().normalize()
        val before = job
        val isSame = viewer.library.folder == path
        close()
        viewer.library = viewer.library.opening(path)
        viewer.settings = viewer.settings.opened(path.toString())
        val started = Indexing(path, IndexCache(viewer.folders.cache, path))
        indexing = started
        job = viewer.scope.launch {
            // What is still being written into the cache of a folder is to be known when that is opened again.
            if (isSame) before?.join()
            launch { started.run() }
            publish(started, showsNewest)
        }
    }

    /** Forgets the folder; what is known of it is kept for the next time. */
    fun close() {
        job?.cancel()
        job = null
        indexing = null
    }

    /** Leaves the logs that wait unread. */
    fun stopReading() {
        indexing?.queue?.passOverWaiting()
    }

    /** Reads what [stopReading] left. */
    fun readAll() {
        indexing?.queue?.wantAll()
    }

    private suspend fun publish(indexing: Indexing, showsNewest: Boolean) {
        newest.begin()
        var shownQueue: IndexQueue? = null
        var shownChanges = -1
        while (true) {
            val hasLooked = indexing.hasLooked
            val queue = indexing.queue
            val state = withContext(Dispatchers.Default) { queue.state() }
            var library = viewer.library.copy(
                hasLooked = hasLooked,
                trouble = indexing.trouble,
                passedOver = state.passedOver,
                reading = if (state.waiting > 0) ReadingProgress(state.read, state.read + state.waiting) else null,
            )
            if (queue !== shownQueue || state.changes != shownChanges) library = library.knowing(state.entries)
            shownQueue = queue
            shownChanges = state.changes
            if (library != viewer.library) viewer.library = library
            if (hasLooked && showsNewest) newest.update(queue, isComplete = state.waiting == 0)
            // Sorting many logs again takes time that the window needs for other things.
            delay(if (state.entries.size > MANY) PERIOD * 5 else PERIOD)
        }
    }

    private companion object {
        val PERIOD = 100.milliseconds
        const val MANY = 2000
    }
}
