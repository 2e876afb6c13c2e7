package badlog.viewer.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.analysis.Span
import badlog.rules.Finding
import badlog.viewer.theme.LocalPalette
import kotlin.math.abs

/**
 * The marks of the findings on the time axis. The pointer on one shades its time and shows its text, a click goes there. Its room
 * is there without findings, too: graphs that become lower while one looks would be drawn twice.
 */
@Composable
internal fun FindingStrip(scene: GraphScene) {
    val palette = LocalPalette.current
    Box(Modifier.fillMaxWidth().height(HEIGHT.dp).background(palette.surface)) {
        Box(
            Modifier
                .fillMaxSize()
                .padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)
                .semantics { contentDescription = "Findings on the time axis" }
                .findingPointer(scene)
                .drawBehind { drawFindings(scene.findings.state.list?.placed.orEmpty(), scene.view.viewport.visible, palette) },
        )
    }
}

private fun Modifier.findingPointer(scene: GraphScene): Modifier = pointerInput(scene) {
    awaitPointerEventScope {
        while (true) {
            val event = awaitPointerEvent()
            val visible = scene.view.viewport.visible
            val change = event.changes.first()
            val x = visible.from + change.position.x / size.width * visible.width
            val found = findingAt(scene.findings.state.list?.placed.orEmpty(), x, REACH * density / size.width * visible.width, visible)
            when (event.type) {
                PointerEventType.Enter, PointerEventType.Move -> scene.findings.point(found)
                PointerEventType.Exit -> scene.findings.point(null)
                PointerEventType.Release -> if (found != null) scene.findings.goTo(found)
                else -> Unit
            }
        }
    }
}

/**
 * Which of [findings] has its mark no further than [reach] from [x], the worst of the nearest, or else holds there; null for
 * none. Marks outside [visible] are not seen.
 */
internal fun findingAt(findings: List<Finding>, x: Double, reach: Double, visible: Span): Finding? {
    val nearest = findings
        .filter { it.time in visible && abs(it.time - x) <= reach }
        .minWithOrNull(compareBy<Finding> { abs(it.time - x) }.thenByDescending { it.severity })
    return nearest ?: findings.filter { finding -> finding.spans.any { x >= it.from - reach / 2 && x <= it.to + reach / 2 } }
        .maxByOrNull { it.severity }
}

private const val HEIGHT = 14
private const val REACH = 6
