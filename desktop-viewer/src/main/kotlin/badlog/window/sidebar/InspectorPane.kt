package badlog.window.sidebar

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import badlog.core.analysis.LogView
import badlog.core.recording.Severity
import badlog.viewer.panel.problemsPanel
import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import badlog.viewer.state.PlaceAction
import badlog.window.compare.ComparedRecordings
import badlog.window.findings.CurrentFindings
import badlog.window.folder.SinceLastMatch
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.LogNotes
import badlog.window.log.OpenRecording
import badlog.window.panel.PanelView
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import badlog.window.todo.FolderTodo
import badlog.window.video.LogVideo
import badlog.window.video.VideoPanel

/** The panel on the right: events, metadata, problems, statistics, findings, notes, values at the cursor, video, modules. */
@Composable
internal fun InspectorPane(
    current: CurrentRecording,
    compared: ComparedRecordings,
    board: GraphBoard,
    view: AxisView,
    events: FilteredEvents,
    findings: CurrentFindings,
    since: SinceLastMatch,
    notes: LogNotes,
    video: LogVideo,
    todo: FolderTodo,
    panels: WindowPanels,
    send: (Action) -> Unit,
    modifier: Modifier = Modifier,
) {
    val tab = panels.state.inspector ?: return
    Column(modifier.background(LocalPalette.current.surface)) {
        BoxWithConstraints {
            // The bar above the graphs has all buttons, too. A narrow window, which has no such bar, has a wide panel.
            val tabs = tabsOf(current.recording).filter { it != InspectorTab.MODULES || maxWidth >= ALL_TABS }
            // In a small window, the panel is narrower than all of its buttons.
            FlowRow(
                Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 4.dp, bottom = 4.dp),
                itemVerticalAlignment = Alignment.CenterVertically,
            ) {
                Text(tab.title, Modifier.widthIn(min = TITLE), fontWeight = FontWeight.SemiBold, maxLines = 1)
                for (other in tabs) {
                    ToolButton("Show ${other.title.lowercase()}", other.icon, isOn = other == tab) {
                        panels.change { inspecting(other) }
                    }
                }
                ToolButton("Close the panel", Icons.Close) { panels.change { withoutInspector() } }
            }
        }
        HorizontalDivider()
        val open = current.recording
        if (open == null) {
            PanelHint("Open a log to see its ${tab.title.lowercase()}.")
        } else {
            // A narrow window shows one part at a time; a person who goes to a place wants to see it.
            val showGraphs = { panels.change { copy(front = FrontPart.GRAPHS) } }
            val go = { action: Action ->
                send(action)
                if (action is FindingAction.GoTo || action is PlaceAction.GoTo) showGraphs()
            }
            when (tab) {
                InspectorTab.EVENTS -> EventsPanel(view, events, open, go, Modifier.fillMaxSize())

                InspectorTab.VALUES -> MetadataPanel(view, open, Modifier.fillMaxSize())

                InspectorTab.PROBLEMS -> {
                    val parts = remember(open) { problemsPanel(open.view.problems) }
                    PanelView(parts, goal = null, send, Modifier.fillMaxSize())
                }

                InspectorTab.STATISTICS -> StatisticsPanel(compared, board, view, open, Modifier.fillMaxSize())

                InspectorTab.CURSOR -> CursorPanel(board, findings, view, open, Modifier.fillMaxSize())

                InspectorTab.FINDINGS -> FindingsPanel(
                    findings,
                    todo,
                    view,
                    board,
                    open,
                    since.state,
                    isComparing = compared.drawn.size > 1,
                    go,
                    Modifier.fillMaxSize(),
                )

                InspectorTab.NOTES -> NotesPanel(notes, todo, open, go, Modifier.fillMaxSize())

                InspectorTab.VIDEO -> VideoPanel(video, open, Modifier.fillMaxSize())

                InspectorTab.MODULES -> ModulesPanel(view, open, go, Modifier.fillMaxSize())
            }
        }
    }
}

private val TITLE = 76.dp

/** The width of a panel with room for the buttons of all tabs. */
private val ALL_TABS = 380.dp

/** Shows [text] in a panel that has nothing else to show. */
@Composable
internal fun PanelHint(text: String) {
    Text(text, Modifier.padding(12.dp), color = LocalPalette.current.muted)
}

/** Returns the panels that [open] has something for. */
private fun tabsOf(open: OpenRecording?): List<InspectorTab> =
    InspectorTab.entries.filter { it != InspectorTab.MODULES || open?.drive != null }

/** Opens and closes the panels on the right. Each button shows how much is in its panel, and its title if it [hasLabels]. */
@Composable
internal fun InspectorTabs(
    current: CurrentRecording,
    findings: CurrentFindings,
    notes: LogNotes,
    panels: WindowPanels,
    hasLabels: Boolean,
) {
    val open = current.recording ?: return
    val palette = LocalPalette.current
    Row(horizontalArrangement = Arrangement.spacedBy(2.dp)) {
        for (tab in tabsOf(open)) {
            val count = countOf(tab, findings, notes, open)
            val hasErrors = when (tab) {
                InspectorTab.PROBLEMS -> open.view.count(Severity.ERROR) > 0
                InspectorTab.FINDINGS -> findings.state.list?.worst == Severity.ERROR
                else -> false
            }
            ToolButton(
                if (count == null) tab.title else "${tab.title}: $count",
                tab.icon,
                text = listOfNotNull(tab.title.takeIf { hasLabels }, count?.takeIf { it > 0 }).joinToString(" ").ifEmpty { null },
                isOn = panels.state.inspector == tab,
                color = if (hasErrors) palette.error else palette.text,
            ) { panels.change { toggled(tab) } }
        }
    }
}

private fun countOf(tab: InspectorTab, findings: CurrentFindings, notes: LogNotes, open: OpenRecording): Int? = when (tab) {
    InspectorTab.EVENTS -> open.eventLogs.sumOf { it.topic.texts.size }
    InspectorTab.VALUES -> open.view.recording.values.size
    InspectorTab.PROBLEMS -> problemsIn(open.view)
    InspectorTab.STATISTICS, InspectorTab.CURSOR, InspectorTab.VIDEO, InspectorTab.MODULES -> null
    InspectorTab.FINDINGS -> findings.state.list?.all?.size
    InspectorTab.NOTES -> notes.all.size
}

/** Returns the number of errors and warnings in [view]. Notes do not count, because healthy logs have them, too. */
internal fun problemsIn(view: LogView): Int = view.count(Severity.ERROR) + view.count(Severity.WARNING)
