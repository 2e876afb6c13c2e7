package badlog.window.app

import androidx.compose.ui.input.key.Key
import badlog.viewer.input.KeyAction
import badlog.viewer.input.ScreenKey
import badlog.window.export.COPY_GRAPHS
import badlog.window.export.EXPORT_PAGE
import badlog.window.export.PageSaver
import badlog.window.export.figure.FigureSaver
import badlog.window.folder.Library
import badlog.window.folder.LogOpener
import badlog.window.formula.FormulaStore
import badlog.window.layout.LayoutFiles
import badlog.window.layout.SAVE_LAYOUT
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.menu.Command
import badlog.window.menu.KeyPress
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.sidebar.WindowPanels
import badlog.window.topics.TopicListing
import badlog.window.video.Player

/** Returns the commands that an exported page also has, with the same keys. */
internal fun actionCommands(perform: (KeyAction) -> Unit): List<Command> = KeyAction.entries.map { Command(it) { perform(it) } }

/** Returns the commands for the window's parts. */
internal fun windowCommands(panels: WindowPanels, formulas: FormulaStore, view: AxisView): List<Command> = listOf(
    Command("Window", "Show or hide statistics across logs", listOf(KeyPress(Key.S, "S"))) {
        panels.change { toggled(MainView.STATISTICS) }
    },
    Command("Window", "Graphs alone, or the lists again", listOf(KeyPress(Key.F, "F", shift = true))) {
        panels.change { graphsAlone() }
    },
    Command(ScreenKey.HELP.group, ScreenKey.HELP.meaning, listOf(KeyPress(Key.F1, "F1"), QUESTION_MARK)) {
        panels.change { copy(help = !panels.state.help) }
    },
    Command("Window", "Close this sheet, or cancel a drag, the selection, the cursors", listOf(KeyPress(Key.Escape, "Esc"))) {
        when {
            panels.state.help -> panels.change { copy(help = false) }
            formulas.sheet != null -> formulas.closeSheet()
            else -> view.cancel()
        }
    },
) + InspectorTab.entries.mapIndexed { index, tab ->
    Command("Window", "${tab.title}: open or close", listOf(KeyPress(DIGITS[index], "${index + 1}", ctrl = true))) {
        panels.change { toggled(tab) }
    }
}

private val QUESTION_MARK = KeyPress(Key.Slash, "?", shift = true)
private val DIGITS = listOf(Key.One, Key.Two, Key.Three, Key.Four, Key.Five, Key.Six, Key.Seven, Key.Eight, Key.Nine)

/** Returns the commands for the folder of logs. */
internal fun libraryCommands(library: Library, panels: WindowPanels, opener: LogOpener, showNewLog: () -> Unit): List<Command> = listOf(
    Command("Logs", "Open a folder of logs", listOf(KeyPress(Key.O, "O", ctrl = true))) { opener.askForFolder() },
    Command("Logs", "Open a log", listOf(KeyPress(Key.O, "O", ctrl = true, shift = true))) { opener.askForLog() },
    Command(ScreenKey.PREVIOUS_LOG) { opener.step(-1) },
    Command(ScreenKey.NEXT_LOG) { opener.step(1) },
    Command(ScreenKey.NEW_LOG, showNewLog),
    Command("Logs", "Search the logs", listOf(KeyPress(Key.Slash, "/"))) { askForSearch(library, panels) },
    Command("Logs", "Show or hide the table of logs", listOf(KeyPress(Key.T, "T"))) { panels.change { toggled(MainView.LOGS) } },
    Command("Logs", "Show or hide charts of the listed logs", listOf(KeyPress(Key.C, "C"))) { panels.change { toggled(MainView.CHARTS) } },
    Command(ScreenKey.PIT) { panels.change { toggled(MainView.PIT) } },
    Command("Logs", "Batteries: which to use next, and the matches of each", listOf(KeyPress(Key.B, "B", shift = true))) {
        panels.change { toggled(MainView.BATTERIES) }
    },
    Command("Logs", "To do: what the team has to do, or the graphs", listOf(KeyPress(Key.D, "D"))) {
        panels.change { toggled(MainView.TODO) }
    },
)

/** Returns the commands for the list of topics. */
internal fun topicCommands(topics: TopicListing, panels: WindowPanels): List<Command> = listOf(
    Command("Topics", "Search the topics; then ↓ and Enter draw one", listOf(KeyPress(Key.F, "F", ctrl = true))) {
        askForTopics(topics, panels)
    },
)

/** Moves the keyboard focus to the search field of the topics. */
internal fun askForTopics(topics: TopicListing, panels: WindowPanels) {
    panels.change { withTopics().copy(main = MainView.GRAPHS, front = FrontPart.TOPICS) }
    topics.change { copy(isSearchAsked = true) }
}

/** Moves the keyboard focus to the search field of the logs. */
private fun askForSearch(library: Library, panels: WindowPanels) {
    panels.change {
        when (main) {
            MainView.LOGS, MainView.CHARTS -> this
            MainView.STATISTICS -> copy(library = true, front = FrontPart.LOGS)
            else -> copy(library = true, main = MainView.GRAPHS, front = FrontPart.LOGS)
        }
    }
    library.change { copy(isSearchAsked = true) }
}

/** Returns the commands for playback. */
internal fun playbackCommands(player: Player): List<Command> = listOf(
    Command("Playback", "Play or pause", listOf(KeyPress(Key.Spacebar, "Space"))) { player.toggle() },
    Command("Playback", "Loop the selection, or the visible range", listOf(KeyPress(Key.L, "L"))) {
        player.toggleLoop()
    },
    Command("Playback", "Slower", listOf(KeyPress(Key.Comma, "<", shift = true))) {
        player.change { faster(-1) }
    },
    Command("Playback", "Faster", listOf(KeyPress(Key.Period, ">", shift = true))) {
        player.change { faster(1) }
    },
)

/** Returns the commands for exporting. */
internal fun exportCommands(pages: PageSaver, figures: FigureSaver, board: GraphBoard): List<Command> = listOf(
    Command("Export", "Export the page of this log", listOf(EXPORT_PAGE)) { pages.savePage() },
    Command("Export", "Copy the picture of the graphs", listOf(COPY_GRAPHS)) { figures.copyShown(board.state.graphs) },
)

/** Returns the commands for layouts. */
internal fun layoutCommands(files: LayoutFiles): List<Command> =
    listOf(Command("Layout", "Save the layout as a file", listOf(SAVE_LAYOUT)) { files.save() })
