package badlog.window.robot

import badlog.window.log.CurrentRecording
import badlog.window.log.LiveView
import badlog.window.log.RecordingLoader
import badlog.window.task.NoticeAction
import badlog.window.task.Notices
import java.nio.file.Path

/** Shows the log that the window records, unless somebody looks at another one. Use it only on the window's thread. */
internal class RecordedLog(
    private val current: CurrentRecording,
    private val live: LiveView,
    private val loader: RecordingLoader,
    private val notices: Notices,
) {
    private var openBefore: Path? = null

    /** Remembers what is open when a person begins to record. */
    fun started() {
        openBefore = current.recording?.file
    }

    /** Shows [log], whose recording has begun, at its newest moment, or offers that; [isPerEnable] if it may have been awaited for long. */
    fun begun(log: Path, isPerEnable: Boolean) {
        val open = current.recording?.file
        val isAwaited = open == null || live.state.isOn || (!isPerEnable && open == openBefore)
        if (isAwaited) show(log) else notices.say("${log.fileName} is being recorded.", NoticeAction("Show") { show(log) })
    }

    private fun show(log: Path) {
        live.await(log)
        loader.open(log)
    }
}
