package badlog.window.graph.xy

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.CacheDrawScope
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.draw.drawWithCache
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.BlendMode
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.path.XyEntry
import badlog.viewer.draw.path.XyFrame
import badlog.viewer.draw.path.XyLog
import badlog.viewer.draw.path.XyPicture
import badlog.viewer.input.DragKind
import badlog.viewer.input.PlotPointer
import badlog.viewer.session.gesture.XyDrag
import badlog.viewer.session.gesture.XyGestures
import badlog.viewer.session.gesture.XyTarget
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Action
import badlog.viewer.state.GraphChange
import badlog.viewer.state.Place
import badlog.window.compare.DrawnRecording
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.receives
import badlog.window.menu.ClosesByEscape
import badlog.window.pen.SkiaImage
import badlog.window.pen.pen
import badlog.window.theme.LineColor
import badlog.window.theme.LineName
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

/**
 * The cached pixels of a drawing: a cursor moving above it does not redraw its strokes. The next drawing of the same size reuses the
 * memory.
 */
internal class KeptPicture {
    private val scope = CanvasDrawScope()
    private var bitmap: ImageBitmap? = null

    /** Returns the picture that [draw] draws, in the size of [cache]; null if that has no pixels. */
    fun of(cache: CacheDrawScope, draw: DrawScope.() -> Unit): ImageBitmap? {
        val width = cache.size.width.toInt()
        val height = cache.size.height.toInt()
        if (width < 1 || height < 1) return null
        val pixels = bitmap?.takeIf { it.width == width && it.height == height } ?: ImageBitmap(width, height)
        bitmap = pixels
        scope.draw(cache, cache.layoutDirection, Canvas(pixels), cache.size) {
            drawRect(Color.Transparent, blendMode = BlendMode.Clear)
            draw()
        }
        return pixels
    }
}

/** The target of gestures over graph [id], which shows [picture]. */
internal class PaneTarget(private val scene: GraphScene, private val id: Int, override val picture: XyPicture) : XyTarget {
    override val place: Place get() = scene.view.place
    override val isCursorLed: Boolean get() = scene.player.state.isPlaying
    override var drag: XyDrag? by mutableStateOf(null)
    override var plane: Plane?
        get() = scene.planes[id]
        set(value) {
            if (value == null) scene.planes.remove(id) else scene.planes[id] = value
        }

    override fun send(action: Action) = scene.view.send(action)
}

/** Returns the picture of [graph], which draws y over x, for [recordings], the open one first. */
internal fun xyPictureOf(graph: BoardGraph, recordings: List<DrawnRecording>): XyPicture =
    XyPicture(graph.lines, graph.origin, recordings.map { XyLog(it.recording.paths, it.name, it.offset) })

/** Returns the picture of the field below the paths of [recordings]; null for none. */
internal fun XyPicture.groundOf(recordings: List<DrawnRecording>): SkiaImage? =
    parts.firstOrNull()?.let { recordings[it.index].recording.fieldPicture }

/** The traces of [spec], each with its place at the cursor. */
@Composable
internal fun XyLegend(scene: GraphScene, spec: BoardGraph) {
    val recordings = scene.recordings
    val picture = remember(spec.lines, spec.origin, recordings) { xyPictureOf(spec, recordings) }
    if (picture.isEmpty) Text("not in this log", color = LocalPalette.current.muted, fontSize = 12.sp)
    for (part in picture.parts) for (entry in part.entries.take(MAX_ENTRIES)) EntryOfTrace(scene, spec, entry)
}

@Composable
private fun EntryOfTrace(scene: GraphScene, spec: BoardGraph, entry: XyEntry) {
    val isHidden = !entry.isShown(spec.hidden)
    val toggle = { scene.board.send(GraphChange.HideLines(spec.id, entry.lines, !isHidden)) }
    Row(
        Modifier.clickable(role = Role.Button, onClick = toggle)
            .semantics { contentDescription = if (isHidden) "Show ${entry.name}" else "Hide ${entry.name}" },
        horizontalArrangement = Arrangement.spacedBy(5.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        LineColor(entry.color, isHidden)
        LineName(listOfNotNull(entry.name, entry.log?.let { shortLabel(it, LABEL_LETTERS) }).joinToString(" · "), isHidden)
        XyValue(scene, entry)
    }
}

/** The place of [entry] at the cursor. It is drawn without layout, because the cursor moves as fast as the mouse. */
@Composable
private fun XyValue(scene: GraphScene, entry: XyEntry) {
    val palette = LocalPalette.current
    val letters = rememberTextMeasurer()
    val style = remember(palette) { TextStyle(color = palette.text, fontSize = 12.sp, fontWeight = FontWeight.Medium) }
    Spacer(
        Modifier.width(VALUE_WIDTH).height(17.dp).drawBehind {
            val text = entry.textAt(Cursors(pinned = scene.view.cursor))
            val room = Constraints(maxWidth = size.width.toInt())
            drawText(letters.measure(text, style, TextOverflow.Ellipsis, softWrap = false, maxLines = 1, constraints = room))
        },
    )
}

private val VALUE_WIDTH = 130.dp
private const val MAX_ENTRIES = 8
private const val LABEL_LETTERS = 20
