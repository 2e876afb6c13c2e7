package badlog.window.graph

import androidx.compose.foundation.layout.size
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.shown.cursor.spokenAt
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.state.StateHolder

/**
 * The text for a screen reader after a key has moved the cursor. It is the cursor's place, with the values or the finding there. The
 * pointer does not change the text, because it moves too fast to be followed.
 */
internal class SpokenCursor(private val current: CurrentRecording, private val board: GraphBoard, private val view: AxisView) :
    StateHolder<String>("") {
    /** Says the place of the cursor that keys move, and the first values of the graphs there. */
    fun sayValues() {
        val open = current.recording ?: return
        val x = view.cursors.moving ?: return
        val names = board.state.graphs.flatMap { it.lines - it.hidden }.distinct()
        change { spokenAt(names.mapNotNull { open.signal(it)?.line }, x, placeOf(x)) }
    }

    /** Says the place of the pinned cursor, and [found], the text of the finding there. */
    fun sayFinding(found: String) {
        val x = view.cursors.pinned ?: return
        if (found.isNotEmpty()) change { "${placeOf(x)}: $found" }
    }

    /** Returns [x] of the open log for people; empty without an open log. */
    fun placeOf(x: Double): String =
        current.recording?.view?.xAxis?.let { withUnit(placeText(x, it, view.viewport.visible.width), it.unit) }.orEmpty()
}

/** The text of [spoken] for screen readers alone, which is not drawn. */
@Composable
internal fun SpokenText(spoken: SpokenCursor) {
    // A text without a size does not exist for screen readers.
    Text(
        spoken.state,
        Modifier.size(1.dp).semantics { liveRegion = LiveRegionMode.Polite },
        color = Color.Transparent,
        softWrap = false,
        maxLines = 1,
    )
}
