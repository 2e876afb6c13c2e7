package badlog.window.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.composed
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import badlog.viewer.state.GraphChange
import badlog.window.choice.AxisOffer
import badlog.window.choice.StationOffer
import badlog.window.graph.mark.FindingStrip
import badlog.window.graph.scene.GraphScene
import badlog.window.theme.LocalPalette
import badlog.window.theme.rememberAskedFocus
import badlog.window.video.PlayerFrames

/**
 * The graphs of the open recording, with overview and playback.
 *
 * @param isOpening whether a recording is being read.
 */
@Composable
internal fun GraphPane(scene: GraphScene, modifier: Modifier = Modifier, isOpening: Boolean = false) {
    PlayerFrames(scene.player)
    val open = scene.current.recording
    if (open == null) {
        NothingOpen(isOpening, modifier)
        return
    }
    val focus = rememberAskedFocus(scene.isFocusAsked) { scene.isFocusAsked = false }
    Column(
        modifier.background(LocalPalette.current.surface).takesKeyboard(scene.board::pointerMoved)
            .focusRequester(focus).focusable().semantics { paneTitle = open.label },
    ) {
        GraphToolbar(scene)
        AxisOffer(scene.axis)
        StationOffer(scene.stations)
        Overview(scene)
        Box(
            Modifier.weight(1f).fillMaxWidth().receivesSignals(scene) { names ->
                scene.board.send(GraphChange.Add(names))
            },
        ) {
            when {
                open.signals.isEmpty() -> NothingRecorded(open, Modifier.fillMaxSize())
                scene.board.state.graphs.isEmpty() -> NoGraphs(scene.board, open, Modifier.fillMaxSize())
                else -> GraphColumn(scene)
            }
        }
        FindingStrip(scene)
        XAxisBar(scene)
    }
}

/** Removes the focus from text fields on a press, so that keys are commands again. Calls [onMove] when the pointer moves. */
private fun Modifier.takesKeyboard(onMove: () -> Unit) = composed {
    val focus = LocalFocusManager.current
    pointerInput(focus) {
        awaitPointerEventScope {
            var place = Offset.Unspecified
            while (true) {
                val event = awaitPointerEvent(PointerEventPass.Initial)
                if (event.type == PointerEventType.Press) focus.clearFocus()
                // There are events, too, when something moves below a resting pointer.
                val now = event.changes.first().position
                if (now != place || event.type == PointerEventType.Scroll || event.type == PointerEventType.Press) onMove()
                place = now
            }
        }
    }
}
