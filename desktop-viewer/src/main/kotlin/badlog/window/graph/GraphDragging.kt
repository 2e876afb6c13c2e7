package badlog.window.graph

import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Modifier
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
