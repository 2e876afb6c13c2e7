package badlog.window.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.plot.drawFlag
import badlog.viewer.draw.plot.drawXBar
import badlog.viewer.session.gesture.PlotGestures
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.cursorText
import badlog.viewer.text.differenceText
import badlog.window.graph.plot.frameOf
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.ViewTarget
import badlog.window.graph.scene.receives
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette

/** The common x axis below the graphs, with the cursor's place; dragging it pans. */
@Composable
internal fun XAxisBar(scene: GraphScene) {
    val palette = LocalPalette.current
    val gestures = remember(scene) { PlotGestures(ViewTarget(scene), isAxis = true) }
    Box(Modifier.fillMaxWidth().height(HEIGHT.dp).background(palette.surface)) {
        Box(
            Modifier
                .fillMaxSize()
                .padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)
                .pointerHoverIcon(PointerIcon.Hand)
                .semantics { contentDescription = "Axis" }
                .receives(gestures)
                .drawBehind {
                    val axis = scene.current.recording?.view?.xAxis ?: return@drawBehind
                    val visible = scene.view.viewport.visible
                    val frame = frameOf(visible)
                    val pen = pen()
                    pen.drawXBar(frame, axis.title, palette.pen)
                    val clocks = scene.current.recording?.clocks
                    for (flag in flagsOf(scene.view.cursors)) {
                        if (flag.x !in visible) continue
                        val other = if (flag.isMain) clocks?.textAt(flag.x) else flag.from?.let { differenceText(it, flag.x, axis) }
                        val text = flag.name + cursorText(flag.x, axis, visible.width, other.orEmpty())
                        pen.drawFlag(frame, flag.x, text, flag.shade, palette.pen)
                    }
                },
        )
    }
}

/** A flag on the axis at [x], called [name]. It has all clocks if [isMain], otherwise the distance from the cursor at [from]. */
private class Flag(val x: Double, val name: String, val shade: Shade, val isMain: Boolean, val from: Double? = null)

/** Returns the flags of [cursors], the more important ones last. Pinned cursors have the accent color. */
private fun flagsOf(cursors: Cursors): List<Flag> {
    val (a, b, hover) = cursors
    return listOfNotNull(
        hover?.let { Flag(it, "", if (a == null) Shade.CURSOR else Shade.MUTED, isMain = a == null, from = a) },
        b?.let { Flag(it, "B ", Shade.ACCENT, isMain = false, from = a) },
        a?.let { Flag(it, if (b == null) "" else "A ", Shade.ACCENT, isMain = true) },
    )
}

private const val HEIGHT = 24
