package badlog.window.export.figure

import androidx.compose.foundation.layout.size
import androidx.compose.runtime.getValue
import androidx.compose.runtime.setValue
import androidx.compose.ui.graphics.toComposeImageBitmap
import badlog.viewer.choices.board.BoardGraph
import badlog.window.compare.ComparedRecordings
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.files.fileNameOf
import badlog.window.files.sayNoLog
import badlog.window.findings.CurrentFindings
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.LogNotes
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.task.openAction
import kotlinx.coroutines.CoroutineScope
import java.awt.datatransfer.Clipboard

/** Saves and copies figures of the current recording's graphs. */
internal class FigureSaver(
    private val scope: CoroutineScope,
    private val current: CurrentRecording,
    private val compared: ComparedRecordings,
    private val view: AxisView,
    private val events: FilteredEvents,
    private val findings: CurrentFindings,
    private val notes: LogNotes,
    private val board: GraphBoard,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
) {
    /** Asks for a file, and writes the figure of [graphs] as they are on the screen. */
    fun save(graphs: List<BoardGraph>, options: FigureOptions) {
        val recording = current.recording ?: return
        val ending = ".${options.format.ending}"
        val file = askToWrite(files, notices, "Save the figure", recording.file.parent, fileNameOf(recording.label), ending) ?: return
        val figure = figureOf(options)
        tasks.run("Drawing ${file.fileName}", { writeFigure(figure, graphs, options.format, file) }) {
            notices.say("Saved $file.", openAction(file, scope, notices))
        }
    }

    /** Copies a picture of [graphs]: only of the first ones, as many as stay readable. */
    fun copyShown(graphs: List<BoardGraph>) = copy(graphs.take(MAX_COPIED))

    /** Draws [graphs] as a figure of the visible range, and copies its picture to the [clipboard]. */
    fun copy(graphs: List<BoardGraph>, clipboard: () -> Clipboard = ::systemClipboard) {
        if (current.recording == null) return sayNoLog(notices)
        if (graphs.isEmpty()) return
        val options = FigureOptions(graphHeight = if (graphs.size == 1) LONE_HEIGHT else FigureOptions().graphHeight)
        val figure = figureOf(options)
        val draw = { imageOf(figure, graphs).toComposeImageBitmap() }
        tasks.run("Copying the picture", { copyImage(draw(), clipboard) }) {
            val what = graphs.singleOrNull()?.let { "“${board.titleOf(it)}”" } ?: "${graphs.size} graphs"
            notices.say("Copied a picture of $what; paste it where you like.")
        }
    }

    private fun figureOf(options: FigureOptions) = LogFigure(
        compared.drawn,
        view.viewport.visible,
        options.width,
        options.graphHeight,
        events.matching,
        findings.state.list?.timeline,
        notes.all.map { it.x },
        board.state.graphs,
        // The pointer's place is accidental, and does not belong in a figure.
        view.cursors.withoutPointer,
    )

    private companion object {
        const val LONE_HEIGHT = 320

        /** The maximum number of graphs in a readable picture. */
        const val MAX_COPIED = 8
    }
}
