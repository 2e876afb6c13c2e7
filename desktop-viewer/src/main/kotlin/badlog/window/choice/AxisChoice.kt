package badlog.window.choice

import badlog.window.compare.ComparedRecordings
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.state.StateHolder

/**
 * The choice whether logs that name no x axis are drawn over their time column, see [badlog.window.log.OpenRecording.overTime]; null
 * until a person chooses. Use it only on the window's thread.
 */
internal class AxisChoice(
    private val current: CurrentRecording,
    private val compared: ComparedRecordings,
    private val board: GraphBoard,
    private val view: AxisView,
) : StateHolder<Boolean?>(null) {
    /** The name of the column that the open log could be drawn over; null if that was already chosen, or there is none. */
    val offered: String? get() = if (state == null) current.recording?.timeColumn?.name else null

    /** Draws all logs [overTime], or over their rows, from now on, and shows all of x. */
    fun choose(overTime: Boolean) {
        change { overTime }
        for (other in compared.state.loaded.values) compared.change { withLoaded(other.overTime(overTime)) }
        val before = current.recording ?: return
        val recording = before.overTime(overTime)
        if (recording === before) return
        // The time has a graph only if it is not the axis.
        val isDefault = board.kept.showsSame(before.standardGraphs)
        current.replace(recording)
        compared.share(recording)
        view.show(recording.span)
        if (isDefault) board.replace(recording.standardGraphs)
    }
}
