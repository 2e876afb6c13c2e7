package badlog.window.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.plot.PlotMarks
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawFinding
import badlog.viewer.draw.plot.drawFlag
import badlog.viewer.draw.plot.drawOverview
import badlog.viewer.draw.plot.drawSelection
import badlog.viewer.draw.plot.drawVisible
import badlog.viewer.draw.plot.drawXBar
import badlog.viewer.session.gesture.OverviewGestures
import badlog.viewer.session.gesture.PlotGestures
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.outline.everChanges
import badlog.viewer.text.cursorText
import badlog.viewer.text.differenceText
import badlog.window.graph.plot.OVERVIEW
import badlog.window.graph.plot.PictureEffect
import badlog.window.graph.plot.PlotRequest
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.drawLines
import badlog.window.graph.plot.frameOf
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.ViewTarget
import badlog.window.graph.scene.receives
import badlog.window.log.OpenRecording
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette
import badlog.window.theme.Palette

/** The whole recording as a strip, with a small curve, the events and the findings. The visible part is a movable window. */
@Composable
internal fun Overview(scene: GraphScene) {
    val palette = LocalPalette.current
    val state = scene.plots.state(OVERVIEW)
    val gestures = remember(scene) { OverviewGestures(ViewTarget(scene)) }
    val density = LocalDensity.current.density
    val spec = remember(scene.current.recording) { scene.current.recording?.let(::overviewSpec) }
    PictureEffect(state, scene.plots.curves) {
        val size = state.size
        if (spec == null || size.width <= 0 || size.height <= 0) {
            null
        } else {
            PlotRequest(spec, scene.recordings.take(1), scene.view.viewport.full, size.width, size.height, palette, density)
        }
    }
    Box(Modifier.fillMaxWidth().height(HEIGHT.dp).background(palette.surface)) {
        Box(
            Modifier
                .fillMaxSize()
                .padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter, top = 2.dp, bottom = 3.dp)
                .onSizeChanged { state.size = it }
                .semantics { contentDescription = "Overview" }
                .receives(gestures),
        ) {
            Spacer(
                Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind { drawWhole(scene, state, palette) },
            )
            Spacer(Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind { drawWindow(scene, palette) })
        }
        HorizontalDivider(Modifier.align(Alignment.BottomCenter))
    }
}

/**
 * Returns the graph in the overview: the battery voltage, which shows a match clearly, or otherwise a topic of numbers. Numbers that change
 * are preferred; null if there are none.
 */
internal fun overviewSpec(open: OpenRecording): BoardGraph? {
    val numbers = open.signals.filter { it.states == null && !it.isDerived }
    val chosen = open.of("battery").firstOrNull()
        ?: numbers.firstOrNull { everChanges(it.topic) }
        ?: numbers.firstOrNull()
        ?: return null
    return BoardGraph(OVERVIEW, chosen.name, listOf(chosen.name))
}

private fun DrawScope.drawWhole(scene: GraphScene, state: PlotState, palette: Palette) {
    val frame = frameOf(scene.view.viewport.full)
    val pen = pen()
    pen.rectangle(frame.left, frame.top, frame.width, frame.height, palette.pen[Shade.PAGE])
    val modes = scene.current.recording?.modes ?: return
    val marks = PlotMarks(modes, scene.events.matching, scene.findings.state.list?.timeline, scene.notes.all.map { it.x })
    pen.drawOverview(frame, marks, palette.pen) { scene.pictureOf(state)?.let { drawLines(it, frame) } }
}

private fun DrawScope.drawWindow(scene: GraphScene, palette: Palette) {
    val frame = frameOf(scene.view.viewport.full)
    val pen = pen()
    scene.findings.shown?.let { pen.drawFinding(frame, it, palette.pen) }
    scene.view.selection?.let { pen.drawSelection(frame, it, palette.pen) }
    if (scene.view.viewport.isZoomed) pen.drawVisible(frame, scene.view.viewport.visible, palette.pen)
    pen.drawCursors(frame, scene.view.cursors, palette.pen)
}

private const val HEIGHT = 48

/** The common x axis below the graphs, with the cursor's place; dragging it pans. */
@Composable
internal fun XAxisBar(scene: GraphScene) {
    val palette = LocalPalette.current
    val gestures = remember(scene) { PlotGestures(ViewTarget(scene), isAxis = true) }
    Box(Modifier.fillMaxWidth().height(AXIS_HEIGHT.dp).background(palette.surface)) {
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

private const val AXIS_HEIGHT = 24
