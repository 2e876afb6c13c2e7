package badlog.viewer.export

import androidx.compose.runtime.Composable
import androidx.compose.ui.input.key.Key
import badlog.recording.RecordingFormat
import badlog.viewer.app.Viewer
import badlog.viewer.export.cut.saveCut
import badlog.viewer.export.figure.FigurePanel
import badlog.viewer.export.pages.savePage
import badlog.viewer.export.pages.savePagesOfFolder
import badlog.viewer.export.pages.savePagesOfTicked
import badlog.viewer.keyboard.Command
import badlog.viewer.keyboard.KeyPress
import badlog.viewer.menu.Menu
import badlog.viewer.menu.MenuEntry
import badlog.viewer.task.NoticeAction
import badlog.viewer.theme.Icons
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.awt.Desktop
import java.awt.GraphicsEnvironment
import java.io.IOException
import java.nio.file.Path

/** The menu of all that can be taken away from the window: pages, figures, parts, pictures. */
@Composable
internal fun TakeAwayMenu(viewer: Viewer) {
    Menu("Take away", "Take away: pages, figures, parts of a log", Icons.Share, { FigurePanel(viewer, it) }) { openPanel ->
        val whyNoLog = "Open a log first.".takeIf { viewer.open == null }
        val whyNoGraph = whyNoLog ?: "There is no graph; draw a topic first.".takeIf { viewer.graphs.graphs.isEmpty() }
        val ticked = viewer.comparison.ticked.size
        val part = if (viewer.selection != null) "The selection" else "The visible range"
        listOf(
            MenuEntry("Export the page of this log…", "One HTML file that opens anywhere, offline", whyNoLog, PAGE.text) {
                savePage(viewer)
            },
            MenuEntry(
                if (ticked == 0) "Export the pages of ticked logs…" else "Export the pages of $ticked ticked logs…",
                whyNot = "Tick logs in the list first.".takeIf { ticked == 0 },
            ) { savePagesOfTicked(viewer) },
            MenuEntry(
                "Export the pages of all logs…",
                "Every log of the folder, with its sub-folders",
                "Open a folder first.".takeIf { viewer.library.folder == null },
            ) { savePagesOfFolder(viewer) },
            MenuEntry(
                "Figure for a report…",
                "The graphs as PNG or SVG, with axes and legend",
                whyNoGraph,
                keepsMenu = true,
                action = openPanel,
            ),
            MenuEntry("Copy the picture of the graphs", "To paste it into a chat or a document", whyNoGraph, COPY.text) {
                copyShown(viewer)
            },
            MenuEntry("$part as a bag…", "With all topics, values and attributes", whyNoLog) { saveCut(viewer, RecordingFormat.BAG) },
            MenuEntry("$part as CSV…", "With all topics, for a spreadsheet", whyNoLog) { saveCut(viewer, RecordingFormat.CSV) },
        )
    }
}

/** What the keyboard takes away. */
internal fun takeAwayCommands(viewer: Viewer): List<Command> = listOf(
    Command("Take away", "Export the page of this log", listOf(PAGE)) { savePage(viewer) },
    Command("Take away", "Copy the picture of the graphs", listOf(COPY)) { copyShown(viewer) },
)

private fun copyShown(viewer: Viewer) = copyGraphs(viewer, viewer.graphs.graphs.take(MOST_COPIED))

private val PAGE = KeyPress(Key.E, "E", ctrl = true)
private val COPY = KeyPress(Key.C, "C", ctrl = true, shift = true)

/** More graphs than these make a picture that nobody can read. */
private const val MOST_COPIED = 8

/** What opens [place], a file or a folder, by the system's program for it; null where the system cannot. */
internal fun openAction(viewer: Viewer, place: Path): NoticeAction? {
    val canOpen = !GraphicsEnvironment.isHeadless() && Desktop.isDesktopSupported() &&
        Desktop.getDesktop().isSupported(Desktop.Action.OPEN)
    if (!canOpen) return null
    return NoticeAction("Open") {
        viewer.scope.launch {
            try {
                withContext(Dispatchers.IO) { Desktop.getDesktop().open(place.toFile()) }
            } catch (_: IOException) {
                viewer.notices.complain("The system has no program that opens $place; open it by hand.")
            } catch (_: IllegalArgumentException) {
                viewer.notices.complain("$place is not there any more.")
            }
        }
    }
}
