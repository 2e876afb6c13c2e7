package badlog.viewer.inspector

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import badlog.recording.Severity
import badlog.viewer.app.InspectorTab
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** Opens and closes the panels at the right; each says how much there is to see in it. */
@Composable
internal fun InspectorTabs(viewer: Viewer) {
    val open = viewer.open ?: return
    val palette = LocalPalette.current
    Row(horizontalArrangement = Arrangement.spacedBy(2.dp)) {
        for (tab in InspectorTab.entries) {
            val count = countOf(tab, viewer, open)
            val hasErrors = when (tab) {
                InspectorTab.PROBLEMS -> open.view.count(Severity.ERROR) > 0
                InspectorTab.FINDINGS -> viewer.findings.list?.worst == Severity.ERROR
                else -> false
            }
            ToolButton(
                if (count == null) tab.title else "${tab.title}: $count",
                tab.icon,
                text = count?.takeIf { it > 0 }?.toString(),
                isOn = viewer.panels.inspector == tab,
                color = if (hasErrors) palette.error else palette.text,
            ) { viewer.panels = viewer.panels.toggled(tab) }
        }
    }
}

private fun countOf(tab: InspectorTab, viewer: Viewer, open: OpenRecording): Int? = when (tab) {
    InspectorTab.EVENTS -> open.eventLogs.sumOf { it.topic.texts.size }
    InspectorTab.VALUES -> open.view.recording.values.size
    InspectorTab.PROBLEMS -> open.view.problems.size
    InspectorTab.STATISTICS -> null
    InspectorTab.FINDINGS -> viewer.findings.list?.all?.size
}
