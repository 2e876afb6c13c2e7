package badlog.window.choice

import badlog.core.recording.Topic
import badlog.window.log.CurrentRecording
import badlog.window.state.StateHolder

/**
 * A person's choice whether logs that name no x axis are drawn over their time column. It is null until a person chooses; see
 * [badlog.window.log.RecordingChoices.overTime]. Use it only on the window's thread.
 */
internal class AxisChoice(private val current: CurrentRecording) : StateHolder<Boolean?>(null) {
    /** The time column over which the open log could be drawn. Null after the choice, or if there is no such column. */
    val offered: Topic? get() = if (state == null) current.recording?.timeColumn else null

    /**
     * Draws all logs that name no x axis over time if [overTime], otherwise over row numbers. Shown recordings are recalculated, see
     * [ShownRecordings].
     */
    fun choose(overTime: Boolean) = change { overTime }
}
