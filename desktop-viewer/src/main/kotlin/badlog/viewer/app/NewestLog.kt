package badlog.viewer.app

import androidx.compose.runtime.snapshotFlow
import badlog.viewer.library.Library
import badlog.viewer.library.index.IndexQueue
import badlog.viewer.recording.CurrentRecording
import badlog.viewer.recording.RecordingLoader
import badlog.viewer.task.Notices
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.filterNotNull
import kotlinx.coroutines.flow.flow
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Shows the newest log before anybody asks: when nothing is open, and instead of one that it has shown itself as long as nobody
 * has done anything with that. To be used on the window's thread only.
 *
 * @param isInUse whether somebody looks closer at what is shown.
 */
internal class NewestLog(
    private val library: Library,
    private val current: CurrentRecording,
    private val loader: RecordingLoader,
    private val opener: LogOpener,
    private val notices: Notices,
    private val isInUse: () -> Boolean,
) {
    private var since = TimeSource.Monotonic.markNow()
    private var shown: Path? = null

    private var keptUntil = Long.MIN_VALUE

    /** Takes [file], which was shown last time, for one that was shown here: only a log written after [millis] since 1970 takes its place. */
    fun keep(file: Path, millis: Long) {
        shown = file
        keptUntil = millis
    }

    /** Shows it whenever there is another one, until cancelled. */
    suspend fun run() = snapshotFlow { library.state.folder }.collectLatest {
        since = TimeSource.Monotonic.markNow()
        val patience = flow {
            emit(Unit)
            delay(PATIENCE)
            emit(Unit)
        }
        val hindrances = snapshotFlow { Triple(loader.isReading, current.recording?.file, isInUse()) }
        combine(library.progress.filterNotNull(), patience, hindrances) { progress, _, _ -> progress }
            .collect { update(it.queue, it.isComplete) }
    }

    /** Shows it, if it is known; [isComplete] says whether all logs of [queue] are. */
    fun update(queue: IndexQueue, isComplete: Boolean) {
        if (loader.isReading) return
        val newest = when {
            isComplete -> library.state.newest
            since.elapsedNow() > PATIENCE && current.recording == null -> queue.newestKnown().firstOrNull { !it.isGray }
            else -> null
        } ?: return
        if (newest.file == shown || !mayChange()) return
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
        /** So long it may take to know all dates; then the file written last is taken for the newest log. */
        val PATIENCE = 1.seconds
    }
}
