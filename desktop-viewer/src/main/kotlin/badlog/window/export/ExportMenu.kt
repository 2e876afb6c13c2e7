package badlog.window.export

import androidx.compose.runtime.Composable
import androidx.compose.ui.input.key.Key
import badlog.window.compare.ComparedRecordings
import badlog.window.export.figure.FigurePanel
import badlog.window.export.figure.FigureSaver
import badlog.window.folder.Library
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.menu.KeyPress
import badlog.window.menu.Menu
import badlog.window.menu.MenuEntry
import badlog.window.theme.Icons

/** The menu of everything that can be exported: pages, figures, parts, pictures. */
@Composable
internal fun ExportMenu(
    current: CurrentRecording,
    library: Library,
    compared: ComparedRecordings,
    board: GraphBoard,
    view: AxisView,
    pages: PageSaver,
    figures: FigureSaver,
    cuts: CutSaver,
) {
    val graphs = board.state.graphs
    Menu("Export", "Export: pages, figures, parts of a log", Icons.Share, { FigurePanel(graphs, figures::save, it) }) { openPanel ->
        val whyNoLog = "Open a log first.".takeIf { current.recording == null }
        val whyNoGraph = whyNoLog ?: "No graph is open; draw a topic first.".takeIf { graphs.isEmpty() }
        val checked = compared.state.checked.size
        val part = if (view.selection != null) "The selection" else "The visible range"
        listOf(
            MenuEntry("Export the page of this log…", "One HTML file that opens anywhere, offline", whyNoLog, EXPORT_PAGE.text) {
                pages.savePage()
            },
            MenuEntry(
                if (checked == 0) "Export the pages of checked logs…" else "Export the pages of $checked checked logs…",
                disabledReason = "Check logs in the list first.".takeIf { checked == 0 },
            ) { pages.savePagesOfChecked() },
            MenuEntry(
                "Export the pages of all logs…",
                "Every log of the folder and its subfolders",
                "Open a folder first.".takeIf { library.state.folder == null },
            ) { pages.savePagesOfFolder() },
            MenuEntry(
                "Figure for a report…",
                "The graphs as PNG or SVG, with axes and legend",
                whyNoGraph,
                keepsMenu = true,
                action = openPanel,
            ),
            MenuEntry("Copy the picture of the graphs", "To paste it into a chat or a document", whyNoGraph, COPY_GRAPHS.text) {
                figures.copyShown(graphs)
            },
            MenuEntry("$part as a bag…", "With all topics, metadata and attributes", whyNoLog) { cuts.save() },
            MenuEntry("$part as CSV…", "With all topics, for a spreadsheet", whyNoLog) { cuts.saveTable() },
            MenuEntry(
                "The logs of this match as a ZIP…",
                "This log and its Driver Station log, unchanged, with their clocks; it opens as one log",
                whyNoLog ?: "Show its Driver Station log first: menu Layout.".takeIf { current.recording?.station == null },
            ) { cuts.saveMatch() },
            MenuEntry("The graphs as CSV…", "$part of their topics, for a spreadsheet", whyNoGraph) { cuts.saveTable(graphs) },
        )
    }
}

internal val EXPORT_PAGE = KeyPress(Key.E, "E", ctrl = true)
internal val COPY_GRAPHS = KeyPress(Key.C, "C", ctrl = true, shift = true)
