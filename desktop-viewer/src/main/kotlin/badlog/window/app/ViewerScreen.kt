package badlog.window.app

import androidx.compose.foundation.background
import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.viewer.input.SEARCH_HELP
import badlog.window.charts.ChartsPane
import badlog.window.compare.CompareBar
import badlog.window.export.ExportMenu
import badlog.window.findings.CurrentFindings
import badlog.window.folder.ArrivalBar
import badlog.window.folder.LibraryPane
import badlog.window.folder.LogTable
import badlog.window.folder.ShownLogs
import badlog.window.formula.FormulaDialog
import badlog.window.graph.GraphPane
import badlog.window.graph.SpokenText
import badlog.window.layout.LayoutMenu
import badlog.window.log.CurrentRecording
import badlog.window.log.LogNotes
import badlog.window.panel.FormSheet
import badlog.window.pit.BatteriesPane
import badlog.window.pit.PitPane
import badlog.window.pit.TodoPane
import badlog.window.robot.RecordingLine
import badlog.window.settings.PaneWidths
import badlog.window.settings.SettingsStore
import badlog.window.sidebar.AcrossPane
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorPane
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.InspectorTabs
import badlog.window.sidebar.MainView
import badlog.window.sidebar.Panels
import badlog.window.sidebar.WindowPanels
import badlog.window.task.StatusLines
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.PaneDivider
import badlog.window.theme.ToolButton
import badlog.window.theme.ViewerTheme
import badlog.window.topics.TopicPane
import badlog.window.welcome.Welcome

/** All of the window's content, made of the parts of [viewer]. */
@Composable
internal fun ViewerScreen(viewer: Viewer) = with(viewer) {
    ViewerTheme(settings.state.theme) {
        keyboard.Watch {
            BoxWithConstraints(Modifier.fillMaxSize().acceptsFiles(::openDropped)) {
                val width = maxWidth
                val isNarrow = width < NARROW
                val showsTopics = panels.state.showsTopics(isRoomy = PaneWidths.leaveHalf(width.value, panels.state.library))
                Column(Modifier.fillMaxSize().background(LocalPalette.current.page)) {
                    TopBar(panels, current, findings, notes, settings, width, showsTopics, heading) {
                        LayoutMenu(current, layouts, keptLayouts, layoutFiles, axis, stations)
                        ExportMenu(current, library, compared, board, view, pages, figures, cuts)
                    }
                    // The pit view shows new logs by itself.
                    if (panels.state.main == MainView.PIT) {
                        LaunchedEffect(newLogs.state) { newLogs.leave() }
                    } else {
                        ArrivalBar(newLogs, ::showNewLog)
                    }
                    Box(Modifier.weight(1f).fillMaxWidth()) {
                        // Without logs, there are no topics.
                        Body(panels.state.copy(topics = showsTopics && !isWithoutLogs), isNarrow, settings, width, panesOf(viewer))
                        val open = current.recording
                        val sheet = formulas.sheet
                        if (open != null && sheet != null) FormulaDialog(formulas, sheet, open, Modifier.align(Alignment.TopCenter))
                        panels.state.form?.let { form ->
                            FormSheet(form, store::send, Modifier.align(Alignment.TopCenter)) { panels.change { copy(form = null) } }
                        }
                        // Its answer would change another folder.
                        LaunchedEffect(library.state.folder) { panels.change { copy(form = null) } }
                        if (panels.state.help) {
                            HelpSheet(commands.map { it.help } + GESTURES + SEARCH_HELP, Modifier.align(Alignment.TopCenter)) {
                                panels.change { copy(help = false) }
                            }
                        }
                    }
                    RecordingLine(recording)
                    StatusLines(notices, tasks, shown.isWaiting)
                    if (isNarrow) FrontTabs(panels)
                }
            }
        }
    }
}

/** The panes between the top and bottom bars of the window. */
private class Panes(
    val logs: @Composable (Modifier) -> Unit,
    val topics: @Composable (Modifier) -> Unit,
    val main: @Composable (Modifier) -> Unit,
    val details: @Composable (Modifier) -> Unit,
)

private fun panesOf(viewer: Viewer) = with(viewer) {
    Panes(
        logs = { LibraryPane(library, robot, recording, settings, shownLogs(), logActions, it) },
        topics = { TopicPane(current, compared, board, view, events, formulas, topics, panels, it) { findings.state.topics } },
        main = { MainPane(viewer, it) },
        details = {
            InspectorPane(current, compared, board, view, events, findings, since, notes, video, todo, panels, store::send, it)
        },
    )
}

@Composable
private fun Body(panels: Panels, isNarrow: Boolean, settings: SettingsStore, width: Dp, panes: Panes) {
    val all = Modifier.fillMaxSize()
    when {
        !isNarrow -> WideBody(panels, settings, width, panes)

        panels.main != MainView.GRAPHS -> panes.main(all)

        // One part at a time, for lack of room.
        else -> when (panels.front) {
            FrontPart.LOGS -> panes.logs(all)
            FrontPart.TOPICS -> panes.topics(all)
            FrontPart.GRAPHS -> panes.main(all)
            FrontPart.DETAILS -> panes.details(all)
        }
    }
}

@Composable
private fun WideBody(panels: Panels, settings: SettingsStore, width: Dp, panes: Panes) {
    val hasLogs = panels.library && (panels.main == MainView.GRAPHS || panels.main == MainView.STATISTICS)
    val hasTopics = panels.topics && panels.main == MainView.GRAPHS
    val hasDetails = panels.inspector != null && panels.main == MainView.GRAPHS
    val widths = settings.state.panes.within(width.value, hasLogs, hasTopics, hasDetails)

    fun drag(by: PaneWidths) = settings.change {
        // A dragged pane starts at its visible width, which in a small window is less than the stored one.
        copy(panes = this.panes.draggedFrom(this.panes.within(width.value, hasLogs, hasTopics, hasDetails), by))
    }

    fun reset(to: PaneWidths.() -> PaneWidths) = settings.change { copy(panes = this.panes.to()) }
    Row(Modifier.fillMaxSize()) {
        if (hasLogs) {
            panes.logs(Modifier.width(widths.logs.dp).fillMaxHeight())
            PaneDivider("Width of the logs", { drag(PaneWidths(it, 0f, 0f)) }) { reset { copy(logs = PaneWidths().logs) } }
        }
        if (hasTopics) {
            panes.topics(Modifier.width(widths.topics.dp).fillMaxHeight())
            PaneDivider("Width of the topics", { drag(PaneWidths(0f, it, 0f)) }) { reset { copy(topics = PaneWidths().topics) } }
        }
        panes.main(Modifier.weight(1f).fillMaxHeight())
        if (hasDetails) {
            PaneDivider("Width of the panel", { drag(PaneWidths(0f, 0f, -it)) }) { reset { copy(details = PaneWidths().details) } }
            panes.details(Modifier.width(widths.details.dp).fillMaxHeight())
        }
    }
}

@Composable
private fun MainPane(viewer: Viewer, modifier: Modifier) = with(viewer) {
    val showGraphs = { panels.change { copy(main = MainView.GRAPHS) } }
    Box(modifier) {
        when (panels.state.main) {
            MainView.GRAPHS -> if (isWithoutLogs) {
                Welcome(opener, ::openSample, ::askForRobot, Modifier.fillMaxSize())
            } else {
                Column(Modifier.fillMaxSize()) {
                    CompareBar(compared, store::send)
                    GraphPane(graphs, Modifier.weight(1f).fillMaxWidth(), loader.isReading)
                }
                SpokenText(spoken)
            }

            MainView.LOGS -> LogTable(library, settings, shownLogs(), logActions, Modifier.fillMaxSize())

            MainView.CHARTS -> ChartsPane(charts, library, settings, logActions, Modifier.fillMaxSize())

            MainView.PIT -> PitPane(library, batteries, todo, logActions, store::send, Modifier.fillMaxSize())

            MainView.BATTERIES -> BatteriesPane(batteries, library, view, logActions, Modifier.fillMaxSize())

            MainView.TODO -> TodoPane(todo, library, view, logActions, Modifier.fillMaxSize())

            MainView.STATISTICS -> AcrossPane(
                view,
                library.state.entries,
                compared.drawn.map { it.recording },
                findings.state.topics,
                board.state.graphs.flatMap { it.lines }.distinct(),
                onOpen = { file ->
                    if (file != current.recording?.file) loader.open(file)
                    showGraphs()
                },
                onSave = { tables.save(it, library.state.folder) },
                onClose = showGraphs,
                Modifier.fillMaxSize(),
            )
        }
    }
}

private fun Viewer.shownLogs() = ShownLogs(current.recording?.file, compared.state.checked)

/** The width below which three lists would leave no room for the graphs. */
internal val NARROW = 1100.dp

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
