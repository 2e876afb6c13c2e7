package badlog.viewer.inspector

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import badlog.viewer.app.InspectorTab
import badlog.viewer.app.Viewer
import badlog.viewer.findings.FindingsPanel
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** The panel at the right: events, values, problems, statistics, findings. */
@Composable
internal fun InspectorPane(viewer: Viewer, modifier: Modifier = Modifier) {
    val tab = viewer.panels.inspector ?: return
    Column(modifier.background(LocalPalette.current.surface)) {
        Row(
            Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 4.dp, bottom = 4.dp),
            horizontalArrangement = Arrangement.spacedBy(2.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Text(tab.title, Modifier.weight(1f), fontWeight = FontWeight.SemiBold, maxLines = 1)
            for (other in InspectorTab.entries) {
                ToolButton("Show ${other.title.lowercase()}", other.icon, isOn = other == tab) {
                    viewer.panels = viewer.panels.inspecting(other)
                }
            }
            ToolButton("Close the panel", Icons.Close) { viewer.panels = viewer.panels.withoutInspector() }
        }
        HorizontalDivider()
        val open = viewer.open
        if (open == null) {
            PanelHint("Open a log to see its ${tab.title.lowercase()}.")
        } else {
            when (tab) {
                InspectorTab.EVENTS -> EventsPanel(viewer, open, Modifier.fillMaxSize())
                InspectorTab.VALUES -> ValuesPanel(open, Modifier.fillMaxSize())
                InspectorTab.PROBLEMS -> ProblemsPanel(open, Modifier.fillMaxSize())
                InspectorTab.STATISTICS -> StatisticsPanel(viewer, open, Modifier.fillMaxSize())
                InspectorTab.FINDINGS -> FindingsPanel(viewer, open, Modifier.fillMaxSize())
            }
        }
    }
}

/** What stands in a panel that has nothing to show. */
@Composable
internal fun PanelHint(text: String) {
    Text(text, Modifier.padding(12.dp), color = LocalPalette.current.muted)
}
