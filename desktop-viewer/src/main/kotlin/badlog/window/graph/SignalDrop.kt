package badlog.window.graph

import androidx.compose.foundation.draganddrop.dragAndDropTarget
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.composed
import androidx.compose.ui.draganddrop.DragAndDropEvent
import androidx.compose.ui.draganddrop.DragAndDropTarget
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.graphics.drawscope.Stroke
import badlog.window.graph.scene.GraphScene
import badlog.window.theme.LocalPalette

/** Accepts dropped signals, and shows that they can be dropped; [onDrop] receives the names that the open recording has. */
internal fun Modifier.receivesSignals(scene: GraphScene, onDrop: (List<String>) -> Unit): Modifier = composed {
    val palette = LocalPalette.current
    val latest by rememberUpdatedState(onDrop)
    val target = remember(scene) { SignalTarget(scene) { latest(it) } }
    dragAndDropTarget({ it.mayHoldSignals() }, target).drawWithContent {
        drawContent()
        if (target.isHovered) {
            drawRect(palette.accent.copy(alpha = 0.08f))
            drawRect(palette.accent, style = Stroke(2 * density))
        }
    }
}

private class SignalTarget(private val scene: GraphScene, private val onDrop: (List<String>) -> Unit) : DragAndDropTarget {
    var isHovered by mutableStateOf(false)
        private set

    override fun onStarted(event: DragAndDropEvent) {
        scene.isReceiving = true
    }

    override fun onEntered(event: DragAndDropEvent) {
        isHovered = true
    }

    override fun onExited(event: DragAndDropEvent) {
        isHovered = false
    }

    override fun onEnded(event: DragAndDropEvent) {
        isHovered = false
        scene.isReceiving = false
    }

    override fun onDrop(event: DragAndDropEvent): Boolean {
        isHovered = false
        val names = event.signalNames().filter { scene.current.recording?.signal(it) != null }
        if (names.isNotEmpty()) onDrop(names)
        return names.isNotEmpty()
    }
}
