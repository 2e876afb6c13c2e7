package badlog.window.export

import badlog.core.analysis.Span
import badlog.core.bag.RecordingWriter
import badlog.core.recording.RecordingFormat
import badlog.files.writeAtomically
import badlog.rules.ofPart
import badlog.rules.timeText
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.shown.table.CsvDraft
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.files.stemOf
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.OpenRecording
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import java.io.IOException
import java.nio.file.Path

/**
 * Writes the rows of [recording] in [span] to [target] as a bag, with its values and attributes. For topics with times of their own, rows
 * are made with the last values at their times, see [partOf].
 *
 * @return a sentence about the written rows.
 * @throws IOException with a sentence for the user, if there is nothing to write or [target] is the recording's own file.
 */
internal fun cutFile(recording: OpenRecording, span: Span, target: Path, progress: (Float) -> Unit = {}): String {
    val part = partOf(recording, span)
    requireOther(recording, part.rows.last + 1 - part.rows.first, target)
    writeAtomically(target) { out ->
        val reported = { done: Int, total: Int ->
            if (Thread.interrupted()) throw InterruptedException()
            progress(done.toFloat() / total)
        }
        val unit = recording.view.xAxis.unit
        val said = part.recording.values.ofPart("${timeText(span.from, unit)} to ${timeText(span.to, unit)}")
        RecordingWriter(part.recording.copy(values = said), RecordingFormat.BAG).write(part.rows.first, part.rows.last + 1, reported) {
                bytes,
                size,
            ->
            out.write(bytes, 0, size)
        }
    }
    val count = part.rows.last + 1 - part.rows.first
    return "Wrote $count rows to $target${part.remark}."
}

/** Saves the current recording, or a part of it, as a file that the person names. */
internal class CutSaver(
    private val current: CurrentRecording,
    private val view: AxisView,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
) {
    /** Asks for a file, and writes the selection, or otherwise the visible range, to it as a bag. */
    fun save() = ask("part", ".bag") { recording, span, target, progress -> cutFile(recording, span, target, progress) }

    /** Saves the same part as a table for a spreadsheet. */
    fun saveTable() = ask("part", ".csv") { recording, span, target, progress ->
        tableFile(recording, CsvDraft.ofAll(recording.view, span), target, progress)
    }

    /** Saves the same part as a table with only the lines of [graphs]. */
    fun saveTable(graphs: List<BoardGraph>) = ask("board", ".csv") { recording, span, target, progress ->
        val lines = graphs.flatMap { it.lines }.distinct().mapNotNull { recording.signal(it)?.line }
        tableFile(recording, CsvDraft.of(recording.view, span, lines), target, progress)
    }

    /** Asks for a file, and writes the logs of the match to it as a ZIP; does nothing if there is only one. */
    fun saveMatch() {
        val recording = current.recording?.takeIf { it.station != null } ?: return
        val title = "Save the logs of this match"
        val target = askToWrite(files, notices, title, recording.file.parent, stemOf(recording.file), ".zip") ?: return
        tasks.run("Writing ${target.fileName}", { matchZipFile(recording, target) }) { notices.say(it) }
    }

    private fun ask(name: String, ending: String, write: (OpenRecording, Span, Path, (Float) -> Unit) -> String) {
        val recording = current.recording ?: return
        val span = view.selection ?: view.viewport.visible
        val title = if (view.selection != null) "Save the selection" else "Save the visible range"
        val target = askToWrite(files, notices, title, recording.file.parent, "${stemOf(recording.file)} $name", ending) ?: return
        tasks.run("Writing ${target.fileName}", { write(recording, span, target, it) }) { notices.say(it) }
    }
}
