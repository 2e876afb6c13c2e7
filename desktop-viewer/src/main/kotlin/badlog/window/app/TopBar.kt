package badlog.window.app

import androidx.compose.foundation.background
import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.window.findings.CurrentFindings
import badlog.window.log.CurrentRecording
import badlog.window.log.LogNotes
import badlog.window.settings.SettingsStore
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.InspectorTabs
import badlog.window.sidebar.MainView
import badlog.window.sidebar.WindowPanels
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.ToolButton

/**
 * The bar at the top of the window: buttons for its parts, the name of the log, and the [menus].
 *
 * @param width the width of the window: in a wide one, each icon has a word beside it.
 * @param showsTopics whether the topics are visible.
 * @param heading the name of the log.
 */
@Composable
internal fun TopBar(
    panels: WindowPanels,
    current: CurrentRecording,
    findings: CurrentFindings,
    notes: LogNotes,
    settings: SettingsStore,
    width: Dp,
    showsTopics: Boolean,
    heading: String,
    menus: @Composable () -> Unit,
) {
    val open = panels.state
    val isNarrow = width < NARROW
    val hasLabels = width >= LABELED
    Row(
        Modifier.fillMaxWidth().background(LocalPalette.current.surface).padding(horizontal = 8.dp, vertical = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        if (!isNarrow) PanelButtons(panels, showsTopics, hasLabels)
        NameText(
            heading,
            Modifier.weight(1f).padding(horizontal = 8.dp),
            fontWeight = FontWeight.SemiBold,
            cut = NameCut.MIDDLE,
        )
        if (!isNarrow) InspectorTabs(current, findings, notes, panels, hasLabels)
        ToolButton("Statistics across logs", Icons.Compare, "Across logs".takeIf { hasLabels }, isOn = open.main == MainView.STATISTICS) {
            panels.change { toggled(MainView.STATISTICS) }
        }
        ToolButton("Charts of the folder’s logs", Icons.Chart, "Charts".takeIf { hasLabels }, isOn = open.main == MainView.CHARTS) {
            panels.change { toggled(MainView.CHARTS) }
        }
        menus()
        val isSystemDark = isSystemInDarkTheme()
        ToolButton("Theme: ${settings.state.theme.name.lowercase()}", Icons.Sun, "Theme".takeIf { hasLabels }) {
            settings.change { copy(theme = theme.other(isSystemDark)) }
        }
        ToolButton("Keys and gestures", Icons.Help, "Keys".takeIf { hasLabels }, isOn = open.help) {
            panels.change { copy(help = !help) }
        }
    }
}

@Composable
private fun PanelButtons(panels: WindowPanels, showsTopics: Boolean, hasLabels: Boolean) {
    ToolButton("Logs: the list at the left", Icons.List, "Logs".takeIf { hasLabels }, isOn = panels.state.library) {
        panels.change { copy(library = !library) }
    }
    ToolButton("Topics", Icons.Tree, "Topics".takeIf { hasLabels }, isOn = showsTopics) {
        panels.change { if (showsTopics) copy(topics = false) else withTopics() }
    }
}

/** From this width, the bar has room for all words beside the name of the log. */
private val LABELED = 1700.dp

/** The bar at the bottom of a narrow window, which selects its visible part. */
@Composable
internal fun FrontTabs(panels: WindowPanels) {
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
                isOn = panels.state.front == part && panels.state.main == MainView.GRAPHS,
            ) {
                val inspector = panels.state.inspector ?: InspectorTab.EVENTS.takeIf { part == FrontPart.DETAILS }
                panels.change {
                    (if (part == FrontPart.TOPICS) withTopics() else this).copy(front = part, main = MainView.GRAPHS, inspector = inspector)
                }
            }
        }
    }
}
