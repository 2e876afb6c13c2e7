package badlog.window.app

import androidx.compose.ui.input.key.Key
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.input.Action
import badlog.window.export.COPY_GRAPHS
import badlog.window.export.EXPORT_PAGE
import badlog.window.export.PageSaver
import badlog.window.export.figure.FigureSaver
import badlog.window.findings.LogFindings
import badlog.window.folder.Library
import badlog.window.formula.FormulaStore
import badlog.window.graph.scene.stepCursor
import badlog.window.layout.LayoutFiles
import badlog.window.layout.SAVE_LAYOUT
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.LogNotes
import badlog.window.menu.Command
import badlog.window.menu.KeyPress
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.sidebar.WindowPanels
import badlog.window.sidebar.placeOfNote
import badlog.window.topics.TopicListing
import badlog.window.video.LogVideo
import badlog.window.video.Player

/** Returns the keys that do the same as on an exported page. */
internal fun actionCommands(
    current: CurrentRecording,
    view: AxisView,
    board: GraphBoard,
    formulas: FormulaStore,
    findings: LogFindings,
    notes: LogNotes,
    panels: WindowPanels,
    video: LogVideo,
): List<Command> = Action.entries.map { action ->
    Command(action) {
        when (action) {
            Action.PREVIOUS_SAMPLE -> stepCursor(current, view, -1)
            Action.NEXT_SAMPLE -> stepCursor(current, view, 1)
            Action.TEN_SAMPLES_BACK -> stepCursor(current, view, -Action.MANY_SAMPLES)
            Action.TEN_SAMPLES_ON -> stepCursor(current, view, Action.MANY_SAMPLES)
            Action.SECOND_CURSOR -> view.changeCursors { withSecond() }
            Action.ZOOM_IN -> view.change { zoomed(1, view.cursor) }
            Action.ZOOM_OUT -> view.change { zoomed(-1, view.cursor) }
            Action.SHOW_ALL -> view.change { reset() }
            Action.PREVIOUS_VIEW -> view.change { back() }
            Action.NEXT_VIEW -> view.change { forward() }
            Action.SHOW_ENABLED -> view.change { showingEnabled(current.recording?.enabled.orEmpty()) }
            Action.PAN_LEFT -> view.change { panned(-Action.PAN_SHARE) }
            Action.PAN_RIGHT -> view.change { panned(Action.PAN_SHARE) }
            Action.CURSOR_VALUES -> panels.change { toggled(InspectorTab.CURSOR) }
            Action.NEW_FORMULA -> formulas.write()
            Action.NEW_NOTE -> writeNote(notes, panels, view)
            Action.NEXT_FINDING -> stepFinding(1, findings, panels)
            Action.PREVIOUS_FINDING -> stepFinding(-1, findings, panels)
            Action.PREVIOUS_FRAME -> video.step(-1)
            Action.NEXT_FRAME -> video.step(1)
            Action.UNDO -> board.undo()
            Action.REDO -> board.redo()
            Action.PIN -> board.current?.let { if (board.isEvidence(it.id)) board.keep(it.id) else board.change { without(it.id) } }
            Action.MOVE_UP -> board.current?.let { moveGraph(it.id, -1, board) }
            Action.MOVE_DOWN -> board.current?.let { moveGraph(it.id, 1, board) }
            Action.NEXT_HEIGHT -> board.current?.let { board.change { resized(it.id, GraphHeight.of(it.height).next.pixels) } }
        }
    }
}

/** Begins a note at the cursor of [view], in its panel. */
private fun writeNote(notes: LogNotes, panels: WindowPanels, view: AxisView) {
    if (notes.state.log == null) return
    panels.change { inspecting(InspectorTab.NOTES) }
    notes.write(placeOfNote(view))
}

/** Goes [steps] findings forward. The panel shows what to look at next, unless a person is reading another panel. */
private fun stepFinding(steps: Int, findings: LogFindings, panels: WindowPanels) {
    findings.step(steps)
    // In a narrow window, nothing is opened in front of the graphs.
    panels.change { if (inspector == null) copy(inspector = InspectorTab.FINDINGS) else this }
}

/** Moves graph [id] by [places], up if negative; it stays in sight. */
private fun moveGraph(id: Int, places: Int, board: GraphBoard) {
    board.change { moved(id, places) }
    if (board.inSight?.contains(id) == false) board.goTo(id)
}

/** Returns the keys for the window's parts. */
internal fun windowCommands(panels: WindowPanels, formulas: FormulaStore, view: AxisView): List<Command> = listOf(
    Command("Window", "Show or hide statistics across logs", listOf(KeyPress(Key.S, "S"))) {
        panels.change { toggled(MainView.STATISTICS) }
    },
    Command("Window", "Open or close this sheet", listOf(KeyPress(Key.F1, "F1"), QUESTION_MARK)) {
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
private val DIGITS = listOf(Key.One, Key.Two, Key.Three, Key.Four, Key.Five, Key.Six, Key.Seven, Key.Eight)

/** Returns the keys for the folder of logs. */
internal fun libraryCommands(library: Library, panels: WindowPanels, opener: LogOpener): List<Command> = listOf(
    Command("Logs", "Open a folder of logs", listOf(KeyPress(Key.O, "O", ctrl = true))) { opener.askForFolder() },
    Command("Logs", "Open a log", listOf(KeyPress(Key.O, "O", ctrl = true, shift = true))) { opener.askForLog() },
    Command("Logs", "Open the previous log of the list", listOf(KeyPress(Key.PageUp, "Page up"))) { opener.step(-1) },
    Command("Logs", "Open the next log of the list", listOf(KeyPress(Key.PageDown, "Page down"))) { opener.step(1) },
    Command("Logs", "Search the logs", listOf(KeyPress(Key.Slash, "/"))) { askForSearch(library, panels) },
    Command("Logs", "Show or hide the table of logs", listOf(KeyPress(Key.T, "T"))) { panels.change { toggled(MainView.LOGS) } },
    Command("Logs", "Show or hide charts of the listed logs", listOf(KeyPress(Key.C, "C"))) { panels.change { toggled(MainView.CHARTS) } },
)

/** Returns the keys for the list of topics. */
internal fun topicCommands(topics: TopicListing, panels: WindowPanels): List<Command> = listOf(
    Command("Topics", "Search the topics; then ↓ and Enter draw one", listOf(KeyPress(Key.F, "F", ctrl = true))) {
        askForTopics(topics, panels)
    },
)

/** Moves the keyboard focus to the search field of the topics. */
internal fun askForTopics(topics: TopicListing, panels: WindowPanels) {
    panels.change { copy(topics = true, main = MainView.GRAPHS, front = FrontPart.TOPICS) }
    topics.change { copy(searchesAsked = searchesAsked + 1) }
}

/** Moves the keyboard focus to the search field of the logs. */
private fun askForSearch(library: Library, panels: WindowPanels) {
    panels.change { if (main == MainView.LOGS || main == MainView.CHARTS) this else copy(library = true, front = FrontPart.LOGS) }
    library.change { copy(searchesAsked = searchesAsked + 1) }
}

/** Returns the keys for playback. */
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

/** Returns the keys for exporting. */
internal fun exportCommands(pages: PageSaver, figures: FigureSaver, board: GraphBoard): List<Command> = listOf(
    Command("Export", "Export the page of this log", listOf(EXPORT_PAGE)) { pages.savePage() },
    Command("Export", "Copy the picture of the graphs", listOf(COPY_GRAPHS)) { figures.copyShown(board.state.graphs) },
)

/** Returns the keys for layouts. */
internal fun layoutCommands(files: LayoutFiles): List<Command> =
    listOf(Command("Layout", "Save the layout as a file", listOf(SAVE_LAYOUT)) { files.save() })
