package badlog.viewer.app

import androidx.compose.ui.input.key.Key
import badlog.viewer.findings.findingCommands
import badlog.viewer.formula.formulaCommands
import badlog.viewer.graph.giveUpGesture
import badlog.viewer.graph.graphCommands
import badlog.viewer.inspector.title
import badlog.viewer.layout.layoutCommands
import badlog.viewer.library.libraryCommands
import badlog.viewer.playback.playbackCommands
import badlog.viewer.takeaway.takeAwayCommands

/** All that the keyboard does, in the order of the help sheet. */
internal fun allCommands(viewer: Viewer): List<Command> =
    libraryCommands(viewer) + graphCommands(viewer) + formulaCommands(viewer) + findingCommands(viewer) +
        playbackCommands(viewer) + takeAwayCommands(viewer) + layoutCommands(viewer) + windowCommands(viewer)

/** What the keyboard does with the window's parts. */
internal fun windowCommands(viewer: Viewer): List<Command> = listOf(
    Command(GROUP, "Statistics across logs, and back", listOf(KeyPress(Key.S, "S"))) {
        viewer.panels = viewer.panels.toggled(MainView.STATISTICS)
    },
    Command(GROUP, "Open or close this sheet", listOf(KeyPress(Key.F1, "F1"), QUESTION_MARK)) {
        viewer.panels = viewer.panels.copy(help = !viewer.panels.help)
    },
    Command(GROUP, "Close this sheet, or give up a drag, the selection, the cursor", listOf(KeyPress(Key.Escape, "Esc"))) {
        when {
            viewer.panels.help -> viewer.panels = viewer.panels.copy(help = false)
            viewer.formulaSheet != null -> viewer.formulaSheet = null
            else -> giveUpGesture(viewer)
        }
    },
) + InspectorTab.entries.mapIndexed { index, tab ->
    Command(GROUP, "${tab.title}: open or close", listOf(KeyPress(DIGITS[index], "${index + 1}", ctrl = true))) {
        viewer.panels = viewer.panels.toggled(tab)
    }
}

private const val GROUP = "Window"
private val QUESTION_MARK = KeyPress(Key.Slash, "?", shift = true)
private val DIGITS = listOf(Key.One, Key.Two, Key.Three, Key.Four, Key.Five)
