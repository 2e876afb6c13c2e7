package badlog.viewer.app

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.export.TakeAwayMenu
import badlog.viewer.inspector.InspectorTabs
import badlog.viewer.layout.LayoutMenu
import badlog.viewer.panels.FrontPart
import badlog.viewer.panels.InspectorTab
import badlog.viewer.panels.MainView
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.Theme
import badlog.viewer.theme.ToolButton

/** What stands along the window's top: which parts are open, what is shown, and what can be done with it. */
@Composable
internal fun TopBar(viewer: Viewer, isNarrow: Boolean = false) {
    val panels = viewer.panels
    Row(
        Modifier.fillMaxWidth().background(LocalPalette.current.surface).padding(horizontal = 8.dp, vertical = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        if (!isNarrow) PanelButtons(viewer)
        Text(
            viewer.open?.label ?: "badlog",
            Modifier.weight(1f).padding(horizontal = 8.dp),
            fontWeight = FontWeight.SemiBold,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
        if (!isNarrow) InspectorTabs(viewer)
        ToolButton("Statistics across logs", Icons.Compare, isOn = panels.main == MainView.STATISTICS) {
            viewer.panels = panels.toggled(MainView.STATISTICS)
        }
        LayoutMenu(viewer)
        TakeAwayMenu(viewer)
        ToolButton("Theme: ${viewer.settings.theme.name.lowercase()}", Icons.Sun) {
            val themes = Theme.entries
            val next = themes[(viewer.settings.theme.ordinal + 1) % themes.size]
            viewer.settings = viewer.settings.copy(theme = next)
        }
        ToolButton("Keys and gestures", Icons.Help, isOn = panels.help) {
            viewer.panels = panels.copy(help = !panels.help)
        }
    }
}

@Composable
private fun PanelButtons(viewer: Viewer) {
    val panels = viewer.panels
    ToolButton("Logs: the list at the left", Icons.List, isOn = panels.library) {
        viewer.panels = panels.copy(library = !panels.library)
    }
    ToolButton("Topics", Icons.Tree, isOn = panels.topics) {
        viewer.panels = panels.copy(topics = !panels.topics)
    }
}

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
