package badlog.window.graph

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotMarks
import badlog.viewer.draw.plot.drawModes
import badlog.viewer.draw.plot.drawPlot
import badlog.viewer.session.gesture.PlotGestures
import badlog.window.graph.plot.PictureEffect
import badlog.window.graph.plot.PlotRequest
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.drawLines
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.ViewTarget
import badlog.window.graph.scene.receives
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette

/** The plot of [spec] with its axes. */
@Composable
internal fun GraphPlot(scene: GraphScene, spec: BoardGraph, modifier: Modifier) {
    val state = scene.plots.state(spec.id)
    val gestures = remember(scene, spec.id) { PlotGestures(ViewTarget(scene, spec.id) { scene.pictureOf(state) }) }
    val latest by rememberUpdatedState(spec)
    val density = LocalDensity.current.density
    val palette = LocalPalette.current
    DisposableEffect(spec.id) {
        scene.plots.show(spec.id, true)
        onDispose { scene.plots.show(spec.id, false) }
    }
    PictureEffect(state, scene.plots.curves) {
        val size = state.size
        if (size.width <= 0 || size.height <= 0) {
            null
        } else {
            val visible = scene.view.viewport.visible
            PlotRequest(latest, scene.recordings, visible, size.width, size.height, palette, density, scene.sharingWith(latest))
        }
    }
    Box(modifier) {
        GraphDrawing(scene, state)
        Box(
            Modifier
                .fillMaxSize()
                .padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)
                .onSizeChanged { state.size = it }
                .pointerHoverIcon(PointerIcon.Crosshair)
                .semantics { contentDescription = "Plot ${scene.board.titleOf(spec)}" }
                .receives(gestures),
        ) {
            CursorOverlay(scene, spec.id, state)
        }
    }
}

/** Everything that does not move with the pointer. It has a layer of its own, which is not redrawn when the pointer moves. */
@Composable
private fun GraphDrawing(scene: GraphScene, state: PlotState) {
    val palette = LocalPalette.current
    Spacer(
        Modifier.fillMaxSize().graphicsLayer().drawBehind {
            val visible = scene.view.viewport.visible
            val left = GraphScene.LEFT_GUTTER.roundToPx().toDouble()
            val width = size.width - left - scene.rightGutter.roundToPx()
            if (width < 1) return@drawBehind
            val frame = PlotFrame(left, 0.0, width, size.height.toDouble(), visible)
            val modes = scene.current.recording?.modes ?: return@drawBehind
            val picture = scene.pictureOf(state) ?: return@drawBehind pen().drawModes(frame, modes, palette.pen)
            val marks = PlotMarks(modes, scene.events.matching, findings = null, scene.notes.all.map { it.x })
            pen().drawPlot(frame, picture.plot, marks, palette.pen, xHeight = 0.0, hasRoom = true, picture.request.frame) {
                drawLines(picture, frame)
            }
        },
    )
}
