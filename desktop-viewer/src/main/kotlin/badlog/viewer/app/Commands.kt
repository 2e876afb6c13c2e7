package badlog.viewer.app

import androidx.compose.ui.input.key.Key
import badlog.plot.gesture.Action
import badlog.viewer.export.takeAwayCommands
import badlog.viewer.findings.stepFinding
import badlog.viewer.formula.writeFormula
import badlog.viewer.graph.giveUpGesture
import badlog.viewer.graph.graphCommands
import badlog.viewer.graph.stepCursor
import badlog.viewer.inspector.title
import badlog.viewer.keyboard.Command
import badlog.viewer.keyboard.KeyPress
import badlog.viewer.layout.layoutCommands
import badlog.viewer.panels.FrontPart
import badlog.viewer.panels.InspectorTab
import badlog.viewer.panels.MainView
import badlog.viewer.playback.togglePlaying

/** All that the keyboard does, in the order of the help sheet. */
internal fun allCommands(viewer: Viewer): List<Command> = libraryCommands(viewer) + actionCommands(viewer) + graphCommands(viewer) +
    playbackCommands(viewer) + takeAwayCommands(viewer) + layoutCommands(viewer) + windowCommands(viewer)

/** What the keyboard does as on an exported page. */
internal fun actionCommands(viewer: Viewer): List<Command> = Action.entries.map { Command(it) { perform(it, viewer) } }

private fun perform(action: Action, viewer: Viewer) = when (action) {
    Action.PREVIOUS_SAMPLE -> stepCursor(viewer, -1)
    Action.NEXT_SAMPLE -> stepCursor(viewer, 1)
    Action.TEN_SAMPLES_BACK -> stepCursor(viewer, -Action.MANY_SAMPLES)
    Action.TEN_SAMPLES_ON -> stepCursor(viewer, Action.MANY_SAMPLES)
    Action.ZOOM_IN -> viewer.viewport = viewer.viewport.zoomed(1, viewer.cursor)
    Action.ZOOM_OUT -> viewer.viewport = viewer.viewport.zoomed(-1, viewer.cursor)
    Action.SHOW_ALL -> viewer.viewport = viewer.viewport.reset()
    Action.PREVIOUS_VIEW -> viewer.viewport = viewer.viewport.back()
    Action.NEXT_VIEW -> viewer.viewport = viewer.viewport.forward()
    Action.SHOW_ENABLED -> viewer.viewport = viewer.viewport.showingEnabled(viewer.open?.enabled.orEmpty())
    Action.PAN_LEFT -> viewer.viewport = viewer.viewport.panned(-Action.PAN_SHARE)
    Action.PAN_RIGHT -> viewer.viewport = viewer.viewport.panned(Action.PAN_SHARE)
    Action.NEW_FORMULA -> writeFormula(viewer)
    Action.NEXT_FINDING -> stepFinding(viewer, 1)
    Action.PREVIOUS_FINDING -> stepFinding(viewer, -1)
}

/** What the keyboard does with the window's parts. */
internal fun windowCommands(viewer: Viewer): List<Command> = listOf(
    Command("Window", "Statistics across logs, and back", listOf(KeyPress(Key.S, "S"))) {
        viewer.panels = viewer.panels.toggled(MainView.STATISTICS)
    },
    Command("Window", "Open or close this sheet", listOf(KeyPress(Key.F1, "F1"), QUESTION_MARK)) {
        viewer.panels = viewer.panels.copy(help = !viewer.panels.help)
    },
    Command("Window", "Close this sheet, or give up a drag, the selection, the cursor", listOf(KeyPress(Key.Escape, "Esc"))) {
        when {
            viewer.panels.help -> viewer.panels = viewer.panels.copy(help = false)
            viewer.formulaSheet != null -> viewer.formulaSheet = null
            else -> giveUpGesture(viewer)
        }
    },
) + InspectorTab.entries.mapIndexed { index, tab ->
    Command("Window", "${tab.title}: open or close", listOf(KeyPress(DIGITS[index], "${index + 1}", ctrl = true))) {
        viewer.panels = viewer.panels.toggled(tab)
    }
}

private val QUESTION_MARK = KeyPress(Key.Slash, "?", shift = true)
private val DIGITS = listOf(Key.One, Key.Two, Key.Three, Key.Four, Key.Five)

/** What the keyboard does with the folder of logs. */
internal fun libraryCommands(viewer: Viewer): List<Command> = listOf(
    Command("Logs", "Open a folder of logs", listOf(KeyPress(Key.O, "O", ctrl = true))) { chooseFolder(viewer) },
    Command("Logs", "Open a log", listOf(KeyPress(Key.O, "O", ctrl = true, shift = true))) { chooseFile(viewer) },
    Command("Logs", "Open the previous log of the list", listOf(KeyPress(Key.PageUp, "Page up"))) { viewer.openStepped(-1) },
    Command("Logs", "Open the next log of the list", listOf(KeyPress(Key.PageDown, "Page down"))) { viewer.openStepped(1) },
    Command("Logs", "Search the logs", listOf(KeyPress(Key.Slash, "/"))) { viewer.askForSearch() },
    Command("Logs", "All logs as a table, and back", listOf(KeyPress(Key.T, "T"))) { viewer.toggleTable() },
)

/** Puts the keyboard into the search field of the logs. */
internal fun Viewer.askForSearch() {
    if (panels.main != MainView.LOGS) panels = panels.copy(library = true, front = FrontPart.LOGS)
    library = library.copy(searchesAsked = library.searchesAsked + 1)
}

/** Shows the table of logs, or the graphs again. */
internal fun Viewer.toggleTable() {
    panels = panels.toggled(MainView.LOGS)
}

/** What the keyboard does with playback. */
internal fun playbackCommands(viewer: Viewer): List<Command> = listOf(
    Command("Playback", "Play or pause", listOf(KeyPress(Key.Spacebar, "Space"))) { togglePlaying(viewer) },
    Command("Playback", "Loop the selection, or what is seen", listOf(KeyPress(Key.L, "L"))) {
        viewer.playback = viewer.playback.copy(loops = !viewer.playback.loops)
    },
    Command("Playback", "Slower", listOf(KeyPress(Key.Comma, "<", shift = true), KeyPress(Key.Comma, ","))) {
        viewer.playback = viewer.playback.faster(-1)
    },
    Command("Playback", "Faster", listOf(KeyPress(Key.Period, ">", shift = true), KeyPress(Key.Period, "."))) {
        viewer.playback = viewer.playback.faster(1)
    },
)
