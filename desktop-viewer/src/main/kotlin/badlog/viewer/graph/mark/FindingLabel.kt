package badlog.viewer.graph.mark

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.layout
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.rules.Finding
import badlog.viewer.findings.findingColor
import badlog.viewer.findings.word
import badlog.viewer.graph.plot.pixelOf
import badlog.viewer.graph.scene.GraphScene
import badlog.viewer.theme.LocalPalette

/** The text of the finding under the pointer, or else of the one at which the cursor was placed, above its mark. */
@Composable
internal fun FindingLabel(scene: GraphScene, modifier: Modifier) {
    val shown by remember(scene) {
        derivedStateOf {
            scene.findings.state.pointed
                ?: scene.findings.state.selected?.takeIf { scene.view.isCursorPinned && isAt(it, scene.view.cursor) }
        }
    }
    val finding = shown ?: return
    val palette = LocalPalette.current
    Box(modifier.fillMaxWidth().padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter, bottom = 2.dp)) {
        Column(
            Modifier
                .layout { measurable, constraints ->
                    val most = minOf(constraints.maxWidth, MAX_WIDTH.dp.roundToPx())
                    val label = measurable.measure(constraints.copy(minWidth = 0, maxWidth = most))
                    layout(constraints.maxWidth, label.height) {
                        val isPointed = finding == scene.findings.state.pointed
                        val pointed = scene.findings.state.pointedPlace.takeIf { it.isFinite() }
                        val place = (if (isPointed) pointed else scene.view.cursor) ?: finding.time
                        val x = pixelOf(place, scene.view.viewport.visible, constraints.maxWidth.toFloat()).toInt()
                        label.place((x - label.width / 2).coerceIn(0, constraints.maxWidth - label.width), 0)
                    }
                }
                .border(1.dp, palette.findingColor(finding.severity), RoundedCornerShape(4.dp))
                .background(palette.raised, RoundedCornerShape(4.dp))
                .padding(horizontal = 8.dp, vertical = 3.dp),
        ) {
            Text(
                "${finding.severity.word}: ${finding.rule}",
                color = palette.findingColor(finding.severity),
                fontSize = 12.sp,
                fontWeight = FontWeight.SemiBold,
                maxLines = 1,
                overflow = TextOverflow.Ellipsis,
            )
            Text(finding.text.take(MAX_LETTERS), fontSize = 12.sp, maxLines = 4, overflow = TextOverflow.Ellipsis)
        }
    }
}

private fun isAt(finding: Finding, cursor: Double?) = finding.time == cursor || finding.spans.any { it.from == cursor }

private const val MAX_WIDTH = 420
private const val MAX_LETTERS = 600
