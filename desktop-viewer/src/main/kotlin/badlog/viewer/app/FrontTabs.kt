package badlog.viewer.app

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** What stands along the foot of a narrow window: which of its parts is seen. */
@Composable
internal fun FrontTabs(viewer: Viewer) {
    Row(
        Modifier.fillMaxWidth().background(LocalPalette.current.surface).padding(4.dp),
        horizontalArrangement = Arrangement.SpaceEvenly,
    ) {
        for (part in FrontPart.entries) {
            val icon = when (part) {
                FrontPart.LOGS -> Icons.List
                FrontPart.TOPICS -> Icons.Tree
                FrontPart.GRAPHS -> Icons.Graph
                FrontPart.DETAILS -> Icons.Table
            }
            val name = part.name.lowercase().replaceFirstChar { it.uppercase() }
            ToolButton(
                "Show the ${part.name.lowercase()}",
                icon,
                text = name,
                isOn = viewer.panels.front == part && viewer.panels.main == MainView.GRAPHS,
            ) {
                val inspector = viewer.panels.inspector ?: InspectorTab.EVENTS.takeIf { part == FrontPart.DETAILS }
                viewer.panels = viewer.panels.copy(front = part, main = MainView.GRAPHS, inspector = inspector)
            }
        }
    }
}
