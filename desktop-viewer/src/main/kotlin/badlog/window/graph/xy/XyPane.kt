package badlog.window.graph.xy

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.draw.drawWithCache
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.path.XyFrame
import badlog.viewer.input.DragKind
import badlog.viewer.input.PlotPointer
import badlog.viewer.session.gesture.XyGestures
import badlog.viewer.state.GraphChange
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.receives
import badlog.window.menu.ClosesByEscape
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette
import badlog.window.theme.Palette
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.drop
import kotlin.time.Duration.Companion.milliseconds

/** The plot of [spec] with its axes: its lines over each other, or as paths on a field. */
@Composable
internal fun XyPane(scene: GraphScene, spec: BoardGraph, modifier: Modifier) {
    val palette = LocalPalette.current
    val recordings = scene.recordings
    val picture = remember(spec.lines, spec.origin, recordings) { xyPictureOf(spec, recordings) }
    val target = remember(scene, spec.id, picture) { PaneTarget(scene, spec.id, picture) }
    val gestures = remember(target) { XyGestures(target) }
    val kept = remember(spec.id) { KeptPicture() }
    ClosesByEscape(target.drag != null) { gestures.giveUp() }
    DisposableEffect(spec.id) {
        scene.plots.show(spec.id, true, needsPicture = false)
        onDispose { scene.plots.show(spec.id, false) }
    }
    fun DrawScope.frameOn(width: Float, height: Float): XyFrame? {
        val plane = target.seen(width.toDouble(), height.toDouble()) ?: return null
        return XyFrame(pen(), plane, width.toDouble(), height.toDouble(), palette.pen)
    }
    KeptPlane(scene, spec)
    Box(modifier) {
        val frame = Modifier.fillMaxSize().padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter, bottom = BELOW)
        Spacer(
            Modifier.fillMaxSize().drawBehind {
                val left = GraphScene.LEFT_GUTTER.toPx()
                val width = size.width - left - scene.rightGutter.toPx()
                val height = size.height - BELOW.toPx()
                if (width <= 0 || height <= 0) return@drawBehind
                translate(left) { frameOn(width, height)?.let { picture.drawAxes(it, left.toDouble()) } }
            },
        )
        Box(
            frame
                .pointerHoverIcon(PointerIcon.Crosshair)
                .semantics { contentDescription = "Plot ${scene.board.titleOf(spec)}" }
                .receives(gestures),
        ) {
            Spacer(
                Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawWithCache {
                    val image = kept.of(this) {
                        val visible = scene.view.viewport.visible
                        frameOn(size.width, size.height)?.let { picture.draw(it, spec.hidden, visible, picture.groundOf(recordings)) }
                    }
                    onDrawBehind { image?.let { drawImage(it) } }
                },
            )
            Spacer(
                Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind {
                    val seen = frameOn(size.width, size.height) ?: return@drawBehind
                    target.drag?.takeIf { it.kind == DragKind.ZOOM }?.let { drawCovered(it.start, it.at, palette) }
                    picture.drawCursors(seen, spec.hidden, scene.view.cursors)
                },
            )
        }
    }
}

/** Draws the rectangle from [start] to [at]. */
private fun DrawScope.drawCovered(start: PlotPointer, at: PlotPointer, palette: Palette) {
    val corner = Offset(start.x.toFloat(), start.y.toFloat()) * density
    val other = Offset(at.x.toFloat(), at.y.toFloat()) * density
    drawRect(palette.accent.copy(alpha = COVERED), corner, Size(other.x - corner.x, other.y - corner.y))
}

private val BELOW = 20.dp
private const val COVERED = 0.16f

/** Stores the visible part of the plane of [spec] on the board once gestures have ended. If the board gets another part, shows that. */
@Composable
private fun KeptPlane(scene: GraphScene, spec: BoardGraph) {
    LaunchedEffect(scene, spec.id, spec.plane) {
        spec.plane.let {
            if (it == null) {
                scene.planes.remove(spec.id)
            } else {
                scene.planes[spec.id] = it
            }
        }
    }
    LaunchedEffect(scene, spec.id) {
        snapshotFlow { scene.planes[spec.id] }.drop(1).collectLatest { plane ->
            delay(REST)
            scene.board.send(GraphChange.ShowPlane(spec.id, plane?.x, plane?.y))
        }
    }
}

private val REST = 300.milliseconds
