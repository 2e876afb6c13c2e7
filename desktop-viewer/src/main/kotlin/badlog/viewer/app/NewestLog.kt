package badlog.viewer.app

import badlog.viewer.library.index.IndexQueue
import badlog.viewer.panels.MainView
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Shows the newest log before anybody asks: when nothing is open, and instead of one that it has shown itself as long as nobody
 * has done anything with that. To be used on the window's thread only.
 */
internal class NewestShowing(private val viewer: Viewer) {
    private var since = TimeSource.Monotonic.markNow()
    private var shown: Path? = null

    /** Another folder is looked at from now on. */
    fun begin() {
        since = TimeSource.Monotonic.markNow()
    }

    /** Shows it, if it is known; [isComplete] says whether all logs of [queue] are. */
    fun update(queue: IndexQueue, isComplete: Boolean) {
        if (viewer.loading.isReading) return
        val newest = when {
            isComplete -> viewer.library.newest
            since.elapsedNow() > PATIENCE && viewer.open == null -> queue.newestKnown().firstOrNull { !it.isGrey }
            else -> null
        } ?: return
        if (newest.file == shown || !mayChange()) return
        if (viewer.open != null) {
            if (newest.isGrey) return
            viewer.notices.say("${newest.title} has just appeared, and is shown now.")
        }
        shown = newest.file
        viewer.openLog(newest)
    }

    private fun mayChange(): Boolean {
        val open = viewer.open ?: return true
        return open.file == shown && viewer.layouts.isUntouched && !viewer.playback.isPlaying && viewer.panels.main == MainView.GRAPHS
    }

    private companion object {
        /** So long it may take to know all dates; then the file written last is taken for the newest log. */
        val PATIENCE = 1.seconds
    }
}
