package badlog.viewer.findings

import androidx.compose.foundation.layout.Row
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import badlog.viewer.app.InspectorTab
import badlog.viewer.app.Viewer
import badlog.viewer.inspector.countText
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** How many findings there are, and the ways to the next and the one before; nothing while there is none. */
@Composable
internal fun FindingButtons(viewer: Viewer) {
    val list = viewer.findings.list ?: return
    val worst = list.worst ?: return
    val palette = LocalPalette.current
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("To the finding before (${BEFORE.text})", Icons.Left, isEnabled = list.placed.isNotEmpty()) { stepFinding(viewer, -1) }
        val at = list.all.indexOf(viewer.findings.chosen)
        ToolButton(
            "Show the list of findings",
            Icons.Diamond,
            text = if (at < 0) countText(list.all.size, "finding") else "${at + 1} of ${list.all.size}",
            color = palette.findingColor(worst),
        ) { viewer.panels = viewer.panels.inspecting(InspectorTab.FINDINGS) }
        ToolButton("To the next finding (${NEXT.text})", Icons.Right, isEnabled = list.placed.isNotEmpty()) { stepFinding(viewer, 1) }
    }
}
