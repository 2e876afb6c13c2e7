package badlog.window.graph

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.background
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.state.GraphChange
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.xy.XyPane
import badlog.window.menu.ContextArea
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
