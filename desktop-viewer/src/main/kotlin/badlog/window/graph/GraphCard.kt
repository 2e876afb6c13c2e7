package badlog.window.graph

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.background
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotMarks
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawFinding
import badlog.viewer.draw.plot.drawModes
import badlog.viewer.draw.plot.drawPlot
import badlog.viewer.draw.plot.drawSamples
import badlog.viewer.draw.plot.drawSelectedHeights
import badlog.viewer.draw.plot.drawSelection
import badlog.viewer.input.DragKind
import badlog.viewer.session.gesture.PlotGestures
import badlog.viewer.state.GraphChange
import badlog.window.graph.plot.PictureEffect
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.PlotRequest
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.drawLines
import badlog.window.graph.plot.frameOf
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.ViewTarget
import badlog.window.graph.scene.receives
import badlog.window.graph.xy.XyPane
import badlog.window.log.PlotGesture
import badlog.window.menu.ContextArea
import badlog.window.pen.pen
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** One graph, [height] dp high: its header and its plot. */
@Composable
internal fun GraphCard(scene: GraphScene, spec: BoardGraph, height: Int) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    val header = remember { MutableInteractionSource() }
    val isHeaderHovered by header.collectIsHoveredAsState()
    var isMenuOpen by remember(spec.id) { mutableStateOf(false) }
    LaunchedEffect(isHovered) { if (isHovered) scene.board.pointed = spec.id }
    Box(
        Modifier
            .fillMaxWidth()
            .height(height.dp)
            .background(palette.surface)
            .hoverable(interactions)
            .semantics { contentDescription = "Graph ${scene.board.titleOf(spec)}" },
    ) {
        Column {
            ContextArea({ graphActions(scene, spec).flatten().map { ContextMenuItem(it.label, it.run) } }) {
                GraphHeader(
                    scene,
                    spec,
                    maxLines = if (height < ROOMY) 1 else MAX_HEADER_LINES,
                    Modifier.hoverable(header).takesGraph(scene.drag, spec.id)
                        .receivesSignals(scene) { names -> scene.board.send(GraphChange.Add(names, before = spec.id)) },
                )
            }
            val plot = Modifier.weight(1f).fillMaxWidth().receivesSignals(scene) { names ->
                scene.board.send(GraphChange.AddLines(spec.id, names))
            }
            if (spec.isXy) XyPane(scene, spec, plot) else GraphPlot(scene, spec, plot)
            HorizontalDivider()
        }
        val isInUse = isHovered || isMenuOpen
        if (isInUse || spec.isYFixed || spec.sharesY || spec.id in scene.planes) {
            val menu = @Composable { GraphMenu(scene, spec, isMenuOpen) { isMenuOpen = it } }
            // Over the plot, a person reads the legend, which all buttons would cover.
            GraphButtons(scene, spec, hasAll = isHeaderHovered || isMenuOpen, menu, Modifier.align(Alignment.TopEnd).hoverable(header))
        }
    }
}

@Composable
private fun GraphButtons(scene: GraphScene, spec: BoardGraph, hasAll: Boolean, menu: @Composable () -> Unit, modifier: Modifier) {
    val palette = LocalPalette.current
    Row(modifier.padding(end = 12.dp).background(palette.surface.copy(alpha = 0.9f), RoundedCornerShape(5.dp))) {
        // On the left, so that no button moves away from the approaching pointer.
        if (hasAll) {
            if (scene.board.isEvidence(spec.id)) {
                ToolButton("Keep this graph on the board", Icons.Pin) { scene.board.keep(spec.id) }
            }
            ToolButton("Copy a picture of this graph", Icons.Copy) { scene.copy(listOf(spec)) }
            ToolButton("Move up", Icons.Up) { scene.board.send(GraphChange.Move(spec.id, -1)) }
            ToolButton("Move down", Icons.Down) { scene.board.send(GraphChange.Move(spec.id, 1)) }
            ToolButton("Remove this graph", Icons.Close) { scene.board.send(GraphChange.Remove(spec.id)) }
        }
        if (spec.isXy && spec.id in scene.planes) {
            ToolButton("Show all of it", Icons.Reset, isOn = true) { scene.planes.remove(spec.id) }
        }
        if (spec.isYFixed && !spec.isXy) {
            ToolButton("Reset Y zoom", Icons.Reset, isOn = true) { scene.board.send(GraphChange.ShowY(spec.id, null)) }
        }
        if (spec.sharesY) {
            ToolButton("Shares its y limits; click to stop sharing", text = "y shared", isOn = true) {
                scene.board.send(GraphChange.ShareY(spec.id, false))
            }
        }
        menu()
    }
}

private const val ROOMY = 110
private const val MAX_HEADER_LINES = 3

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

/** Everything that moves with the pointer: the cursor with the samples it reads, the selection, a finding, and a drag. */
@Composable
internal fun CursorOverlay(scene: GraphScene, id: Int, state: PlotState) {
    val palette = LocalPalette.current
    Spacer(
        Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind {
            val frame = frameOf(scene.view.viewport.visible)
            val pen = pen()
            scene.findings.shown?.let { pen.drawFinding(frame, it, palette.pen) }
            scene.view.selection?.let { pen.drawSelection(frame, it, palette.pen) }
            scene.view.gesture?.let { pen.drawGesture(it, id, frame, scene.pictureOf(state), palette.pen) }
            pen.drawCursors(frame, scene.view.cursors, palette.pen)
            val cursor = scene.view.cursor ?: return@drawBehind
            scene.pictureOf(state)?.let { pen.drawSamples(frame, it.plot, it.lines, cursor, palette.pen) }
        },
    )
}

private fun Pen.drawGesture(gesture: PlotGesture, id: Int, frame: PlotFrame, picture: PlotPicture?, colors: PenColors) {
    val drag = gesture.drag
    when (drag.kind) {
        DragKind.PAN -> Unit

        DragKind.ZOOM, DragKind.SELECT -> drawSelection(frame, drag.xSpan, colors)

        DragKind.ZOOM_Y -> {
            if (gesture.graph != id || picture == null) return
            drawSelectedHeights(frame, drag.ySpan.from * picture.plotHeight, drag.ySpan.to * picture.plotHeight, colors)
        }
    }
}
