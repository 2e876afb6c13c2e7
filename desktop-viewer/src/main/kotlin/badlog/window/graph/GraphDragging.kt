package badlog.window.graph

import androidx.compose.foundation.draganddrop.dragAndDropTarget
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.composed
import androidx.compose.ui.draganddrop.DragAndDropEvent
import androidx.compose.ui.draganddrop.DragAndDropTarget
import androidx.compose.ui.draganddrop.awtTransferable
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.isPrimaryPressed
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.choices.board.isDroppedInto
import badlog.viewer.input.DragKind
import badlog.window.graph.scene.DropTarget
import badlog.window.graph.scene.GraphDrag
import badlog.window.graph.scene.GraphScene
import badlog.window.menu.ClosesByEscape
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.labelFrame
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.IOException

/** Makes the element a handle for dragging graph [id]. */
internal fun Modifier.takesGraph(drag: GraphDrag, id: Int): Modifier = pointerInput(drag, id) {
    awaitPointerEventScope {
        while (true) {
            val event = awaitPointerEvent()
            // A line's name in the legend, which hides it, may have consumed the press.
            val isFree = event.type == PointerEventType.Press && event.buttons.isPrimaryPressed && event.changes.none { it.isConsumed }
            if (isFree) drag.take(id)
        }
    }
}

/** Follows the pointer over all graphs while one is dragged, and marks its target in the colors of [palette]. */
internal fun Modifier.dragsGraphs(drag: GraphDrag, palette: Palette): Modifier = pointerInput(drag) {
    awaitPointerEventScope {
        while (true) {
            // Handled before the graphs, because the pressed one may have been scrolled away.
            val event = awaitPointerEvent(PointerEventPass.Initial)
            val change = event.changes.first()
            val isDragged = when (event.type) {
                PointerEventType.Press -> drag.pressAt(change.position).let { false }
                PointerEventType.Move -> drag.move(change.position, DragKind.MIN_DISTANCE.toFloat() * density)
                PointerEventType.Release -> drag.release()
                else -> false
            }
            if (isDragged) change.consume()
        }
    }
}.drawWithContent {
    drawContent()
    drag.target?.takeIf { it.id != drag.graph?.id }?.let { drawTarget(it, palette) }
}

private fun DrawScope.drawTarget(target: DropTarget, palette: Palette) {
    val top = target.top.toFloat()
    val thick = LINE * density
    if (isDroppedInto(target.share)) {
        drawRect(palette.accent.copy(alpha = 0.08f), Offset(0f, top), Size(size.width, target.height.toFloat()))
        drawRect(palette.accent, Offset(0f, top), Size(size.width, target.height.toFloat()), style = Stroke(thick))
    } else {
        val edge = if (target.share < 0.5) top else top + target.height
        drawRect(palette.accent, Offset(0f, (edge - thick / 2).coerceIn(0f, size.height - thick)), Size(size.width, thick))
    }
}

/** The dragged graph's title beside the pointer. Near the edges of the graphs' [height], in pixels, it scrolls them. */
@Composable
internal fun DraggedGraph(scene: GraphScene, height: Int) {
    val drag = scene.drag
    val graph = drag.graph
    ClosesByEscape(graph != null) { drag.cancel() }
    if (graph == null) return
    val palette = LocalPalette.current
    val list = scene.list
    val isUp = drag.pointer.y < EDGE
    val isDown = drag.pointer.y > height - EDGE
    LaunchedEffect(isUp, isDown) {
        while ((isUp && list.canScrollBackward) || (isDown && list.canScrollForward)) {
            withFrameNanos { }
            list.dispatchRawDelta(if (isUp) -SCROLL else SCROLL)
        }
    }
    NameText(
        scene.board.titleOf(graph),
        Modifier
            .offset { IntOffset(drag.pointer.x.toInt() + BESIDE.dp.roundToPx(), drag.pointer.y.toInt() + BESIDE.dp.roundToPx()) }
            .widthIn(max = 260.dp)
            .labelFrame(palette.accent),
        fontSize = 12.sp,
    )
}

private const val LINE = 3
private const val BESIDE = 12
private const val EDGE = 40f
private const val SCROLL = 10f

/** Returns the signals [names] for dragging: their names as text, one per line. */
internal fun signalTransfer(names: List<String>): Transferable = StringSelection(names.joinToString("\n"))

/** Returns the names of signals that [transfer] has, as [signalTransfer] wrote them; empty for anything else, such as files. */
internal fun signalNames(transfer: Transferable): List<String> {
    if (!mayHoldSignals(transfer)) return emptyList()
    return try {
        (transfer.getTransferData(DataFlavor.stringFlavor) as? String).orEmpty().lines().filter { it.isNotEmpty() }
    } catch (_: UnsupportedFlavorException) {
        emptyList()
    } catch (_: IOException) {
        emptyList()
    }
}

/** Returns whether [transfer] may contain names of signals: its content is not known while it is being dragged. */
internal fun mayHoldSignals(transfer: Transferable): Boolean =
    transfer.isDataFlavorSupported(DataFlavor.stringFlavor) && !transfer.isDataFlavorSupported(DataFlavor.javaFileListFlavor)

/** Returns the names of signals that this event drops. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun DragAndDropEvent.signalNames(): List<String> = signalNames(awtTransferable)

/** Returns whether the dragged content may be names of signals. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun DragAndDropEvent.mayHoldSignals(): Boolean = mayHoldSignals(awtTransferable)

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
