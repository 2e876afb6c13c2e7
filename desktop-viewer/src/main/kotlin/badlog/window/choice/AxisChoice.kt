package badlog.window.choice

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.core.recording.PathName
import badlog.core.recording.Topic
import badlog.viewer.text.axisQuestion
import badlog.window.log.CurrentRecording
import badlog.window.state.StateHolder
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

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

/** Asks once for the x axis of logs that name none; empty if the axis is known. */
@Composable
internal fun AxisOffer(choice: AxisChoice) {
    val topic = choice.offered ?: return
    val column = PathName.baseNameOf(topic.name)
    FlowRow(
        Modifier.fillMaxWidth().background(LocalPalette.current.accentSoft).padding(start = 12.dp, end = 4.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
    ) {
        Text(axisQuestion(topic), Modifier.padding(end = 8.dp, top = 4.dp, bottom = 4.dp))
        ToolButton("Draw over “$column”, here and in the folder’s other logs", text = "Draw over “$column”") { choice.choose(true) }
        ToolButton("Keep row numbers; the menu Layout can change it", text = "Keep row numbers") { choice.choose(false) }
    }
}
