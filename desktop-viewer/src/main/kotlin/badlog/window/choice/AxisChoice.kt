package badlog.window.choice

import badlog.window.log.CurrentRecording
import badlog.window.state.StateHolder

/**
 * The choice whether logs that name no x axis are drawn over their time column, see
 * [badlog.window.log.RecordingChoices.overTime]; null until a person chooses. Use it only on the window's thread.
 */
internal class AxisChoice(private val current: CurrentRecording) : StateHolder<Boolean?>(null) {
    /** The name of the column that the open log could be drawn over; null if that was already chosen, or there is none. */
    val offered: String? get() = if (state == null) current.recording?.timeColumn?.name else null

    /** Chooses for all logs that name no x axis: [overTime], or over their rows. What is shown of them follows, see [ShownRecordings]. */
    fun choose(overTime: Boolean) = change { overTime }
}
