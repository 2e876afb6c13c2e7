package badlog.window.app

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import badlog.catalog.folder.IndexQueue
import badlog.window.folder.Library
import badlog.window.folder.LogOpener
import badlog.window.layout.LastOpen
import badlog.window.log.CurrentRecording
import badlog.window.log.RecordingLoader
import badlog.window.task.Notices
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.filterNotNull
import kotlinx.coroutines.flow.flow
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Shows the newest log automatically. It does so if nothing is open, or the open log was opened here and is not in use. Use it only on the
 * window's thread.
 *
 * @param recorded returns the log that this window is recording, which is shown or offered elsewhere; null for none.
 * @param isInUse returns whether a person is using the open log.
 */
internal class NewestLog(
    private val library: Library,
    private val current: CurrentRecording,
    private val loader: RecordingLoader,
    private val opener: LogOpener,
    private val notices: Notices,
    private val recorded: () -> Path?,
    private val isInUse: () -> Boolean,
) {
    private var since = TimeSource.Monotonic.markNow()
    private var shown: Path? = null

    private var keptUntil = Long.MIN_VALUE
    private var isBeginning by mutableStateOf(false)

    /**
     * Opens the log that was open last, as returned by [find], unless another log is open by then. Only a log written later replaces it.
     * While [find] runs, nothing is opened here.
     */
    suspend fun beginWith(find: suspend () -> LastOpen?) {
        isBeginning = true
        val last = find()
        if (last != null && current.recording == null && !loader.isReading) {
            shown = last.file
            keptUntil = last.millis
            loader.open(last.file)
        }
        isBeginning = false
    }

    /** Returns whether [file] was opened here, and not by a person. */
    fun hasShown(file: Path): Boolean = file == shown

    /** Shows the newest log whenever there is a newer one, until cancelled. */
    suspend fun run() = snapshotFlow { library.state.folder }.collectLatest {
        since = TimeSource.Monotonic.markNow()
        val patience = flow {
            emit(Unit)
            delay(PATIENCE)
            emit(Unit)
        }
        val hindrances = snapshotFlow { listOf(isBeginning, loader.isReading, current.recording?.file, isInUse()) }
        combine(library.progress.filterNotNull(), patience, hindrances) { progress, _, _ -> progress }
            .collect { update(it.queue, it.isComplete) }
    }

    /** Shows the newest log if it is known; [isComplete] says whether all logs of [queue] are known. */
    fun update(queue: IndexQueue, isComplete: Boolean) {
        if (isBeginning || loader.isReading) return
        val newest = when {
            isComplete -> library.state.newest
            since.elapsedNow() > PATIENCE && current.recording == null -> queue.newestKnown().firstOrNull { !it.isGray }
            else -> null
        } ?: return
        if (newest.file == shown || newest.file == recorded() || !mayChange()) return
        if (current.recording != null && newest.source.modified <= keptUntil) return
        if (current.recording != null) {
            if (newest.isGray) return
            notices.say("${newest.title} is new, and is shown now.")
        }
        shown = newest.file
        opener.open(newest)
    }

    private fun mayChange(): Boolean {
        val open = current.recording ?: return true
        return open.file == shown && !isInUse()
    }

    private companion object {
        /** The time to wait for all dates; after that, the file last written counts as the newest log. */
        val PATIENCE = 1.seconds
    }
}
