package badlog.window.robot

import badlog.window.log.CurrentRecording
import badlog.window.log.LiveView
import badlog.window.log.RecordingLoader
import badlog.window.task.NoticeAction
import badlog.window.task.Notices
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Shows the log that the window records, unless a person looks at another one. Use it only on the window's thread.
 *
 * @param isWriting returns whether a person is writing something that belongs to the open log.
 */
internal class RecordedLog(
    private val current: CurrentRecording,
    private val live: LiveView,
    private val loader: RecordingLoader,
    private val notices: Notices,
    private val isWriting: () -> Boolean,
) {
    private var askedSince: TimeSource.Monotonic.ValueTimeMark? = null
    private var openBefore: Path? = null

    /** Remembers the open log when a person begins to record, and that the person expects to see the recording soon. */
    fun started() {
        openBefore = current.recording?.file
        askedSince = TimeSource.Monotonic.markNow()
    }

    /** Shows [log], which is now being recorded, at its newest moment, or offers to show it. */
    fun begun(log: Path) {
        val open = current.recording?.file
        val isJustAsked = open == openBefore && askedSince?.let { it.elapsedNow() < PATIENCE } == true
        askedSince = null
        val isFree = !loader.isReading && !isWriting() && (open == null || isJustAsked || live.isUntouched)
        if (isFree) show(log) else notices.say("${log.fileName} is being recorded.", NoticeAction("Show") { show(log) })
    }

    private fun show(log: Path) {
        live.await(log)
        loader.open(log)
    }

    private companion object {
        /** The time after which a person is assumed to be doing something else. */
        val PATIENCE = 10.seconds
    }
}
