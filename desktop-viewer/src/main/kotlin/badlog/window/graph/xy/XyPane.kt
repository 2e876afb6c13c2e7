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
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.BoardGraph
import badlog.window.graph.scene.GraphScene
import badlog.window.menu.ClosesByEscape
import badlog.window.theme.LocalPalette
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.drop
import kotlin.time.Duration.Companion.milliseconds

/** The plot of [spec], whose lines are drawn over each other or as paths on a field, with its axes. */
@Composable
internal fun XyPane(scene: GraphScene, spec: BoardGraph, modifier: Modifier) {
    val palette = LocalPalette.current
    val recordings = scene.recordings
    val xys = remember(spec.lines, spec.origin, recordings) { drawnXys(spec, recordings) }
    val letters = rememberTextMeasurer(cacheSize = TEXTS)
    val drag = remember(spec.id) { XyDrag() }
    val kept = remember(spec.id) { KeptPicture() }
    ClosesByEscape(drag.giveUp != null) { drag.giveUp?.invoke() }
    DisposableEffect(spec.id) {
        scene.plots.show(spec.id, true, needsPicture = false)
        onDispose { scene.plots.show(spec.id, false) }
    }
    fun planeOn(width: Float, height: Float) = seenOf(scene.planes[spec.id], xys, width, height)
    KeptPlane(scene, spec)
    Box(modifier) {
        val frame = Modifier.fillMaxSize().padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter, bottom = BELOW)
        Spacer(
            Modifier.fillMaxSize().drawBehind {
                val left = GraphScene.LEFT_GUTTER.toPx()
                val box = Rect(left, 0f, size.width - scene.rightGutter.toPx(), size.height - BELOW.toPx())
                if (box.width > 0 &&
                    box.height > 0
                ) {
                    planeOn(box.width, box.height)?.let { drawXyAxes(it, box, xys[0].plot, letters, palette) }
                }
            },
        )
        Box(
            frame
                .pointerHoverIcon(PointerIcon.Crosshair)
                .semantics { contentDescription = "Plot ${spec.title}" }
                .xyPointer(scene, spec.id, xys, ::planeOn, drag),
        ) {
            Spacer(
                Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawWithCache {
                    val plane = planeOn(size.width, size.height)
                    val picture = plane?.let {
                        kept.of(this) {
                            drawXyGround(plane, xys[0].plot, xys[0].drawn.recording.fieldPicture, palette)
                            for (xy in xys) drawXyTraces(xy, spec, plane, scene.view.viewport.visible, palette)
                            for (xy in xys) drawXyNotes(xy, plane, scene.view.viewport.visible, letters, palette)
                        }
                    }
                    onDrawBehind { picture?.let { drawImage(it) } }
                },
            )
            Spacer(
                Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind {
                    val plane = planeOn(size.width, size.height) ?: return@drawBehind
                    drag.covered?.let { drawRect(palette.accent.copy(alpha = COVERED), it.topLeft, it.size) }
                    scene.view.secondCursor?.let { second ->
                        for (xy in xys) drawXyCursor(xy, spec, plane, second, palette, isSecond = true)
                    }
                    scene.view.cursor?.let { cursor -> for (xy in xys) drawXyCursor(xy, spec, plane, cursor, palette) }
                },
            )
        }
    }
}

private val BELOW = 20.dp
private const val TEXTS = 64
private const val COVERED = 0.16f

/** Stores the visible part of the plane of [spec] on the board once gestures have ended, and shows what the board has. */
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
            scene.board.change { withPlane(spec.id, plane?.x, plane?.y) }
        }
    }
}

private val REST = 300.milliseconds
