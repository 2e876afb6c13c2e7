package badlog.window.export

import badlog.catalog.match.FileForZip
import badlog.catalog.match.writeMatchZip
import badlog.core.analysis.Span
import badlog.core.analysis.resampled
import badlog.core.bag.RecordingWriter
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.files.writeAtomically
import badlog.rules.ofPart
import badlog.rules.timeText
import badlog.signals.match.files.FileRole
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.shown.table.CsvDraft
import badlog.viewer.shown.table.TableRows
import badlog.viewer.shown.table.rowsWithin
import badlog.viewer.text.countText
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.files.stemOf
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.OpenRecording
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import java.io.IOException
import java.nio.file.Files
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

/**
 * A part to cut out of a recording.
 *
 * @property rows the rows of [recording] to cut out; empty for none.
 * @property remark an addition to a sentence about how the rows were made; empty if they are rows of the file.
 */
internal class Cut(val recording: Recording, val rows: IntRange, val remark: String = "")

/** Returns the part of [recording] in [span]. For topics with times of their own, it makes rows, see [TableRows]. */
internal fun partOf(recording: OpenRecording, span: Span): Cut {
    // The Driver Station's topics stay in its own file.
    val whole = recording.view.recording.run { copy(topics = topics.filter { it.name !in recording.stationTopics }) }
    if (recording.logged.recording.topics.none {
            it.times != null && it.name !in recording.stationTopics
        }
    ) {
        return rowsOf(recording, whole, span)
    }
    val range = recording.view.xAxis.range ?: return Cut(whole, IntRange.EMPTY)
    val part = Span(maxOf(span.from, range.start), minOf(span.to, range.endInclusive))
    if (!(part.from <= part.to)) return Cut(whole, IntRange.EMPTY)
    val densest = whole.topics.maxBy { topic -> topic.times?.count { it in part } ?: 0 }
    val made = TableRows.of(part, whole.topics.size, densest.name, densest.times ?: DoubleArray(0))
    return Cut(resampled(whole, made.times), made.times.indices, made.remark)
}

/** Returns the rows of the file, with a column for each formula that has a value in each row. */
private fun rowsOf(recording: OpenRecording, whole: Recording, span: Span): Cut {
    val rows = rowsWithin(recording.view.xAxis.positions, span)
    val (columns, others) = whole.topics.partition { topic ->
        recording.signal(topic.name)?.definition == null || (topic.times == null && topic.samples.size == whole.rowCount)
    }
    if (others.isEmpty()) return Cut(whole, rows)
    val names = others.joinToString { "“${it.name}”" }
    return Cut(whole.copy(topics = columns), rows, ", without $names, which does not have a value in each row")
}

/**
 * Writes the file of [recording] and the shown Driver Station's log of its match to [target], a ZIP that opens as one log.
 *
 * @return a sentence about it.
 * @throws IOException with a sentence for the user, if a file cannot be read or written.
 */
internal fun matchZipFile(recording: OpenRecording, target: Path): String {
    val station = checkNotNull(recording.station) { "No Driver Station's log is shown with ${recording.file}." }
    // The error of a fit by one moment, or by clocks, is a guess.
    val error = station.fit.run { error.takeIf { edges > 1 } }
    val files = listOf(
        FileForZip(recording.file, FileRole.ROBOT, 0.0, null),
        FileForZip(station.log.path, FileRole.STATION, station.fit.seconds, error),
    )
    writeAtomically(target) { writeMatchZip(files, it) }
    return "Wrote ${recording.file.fileName} and ${station.log.name} to $target, which opens as one log."
}

/**
 * Writes the table of [draft], a part of [recording], to [target].
 *
 * @return a sentence about the written rows.
 * @throws IOException with a sentence for the user, if there is nothing to write or [target] is the recording's own file.
 */
internal fun tableFile(recording: OpenRecording, draft: CsvDraft, target: Path, progress: (Float) -> Unit = {}): String {
    while (draft.step()) {
        if (Thread.interrupted()) throw InterruptedException()
        progress(draft.share.toFloat() * PREPARED)
    }
    val table = draft.table
    requireOther(recording, table.rowCount, target)
    writeAtomically(target) { out ->
        out.write(table.header.encodeToByteArray())
        for (row in 0 until table.rowCount step ROWS) {
            if (Thread.interrupted()) throw InterruptedException()
            progress(PREPARED + (1 - PREPARED) * row / table.rowCount)
            out.write(table.text(row, ROWS).encodeToByteArray())
        }
    }
    return "Wrote ${countText(table.rowCount, "row")} to $target${table.remark}."
}

/** @throws IOException if there are no [rows], or [target] is the file of [recording] itself. The message is a sentence for the user. */
internal fun requireOther(recording: OpenRecording, rows: Int, target: Path) {
    if (rows == 0) throw IOException("There are no samples in the visible range; show a part of the log that has some.")
    if (Files.exists(target) && Files.exists(recording.file) && Files.isSameFile(target, recording.file)) {
        throw IOException("${target.fileName} is the open log itself; select another name.")
    }
}

private const val ROWS = 2000

/** The progress at which the writing of rows begins. */
private const val PREPARED = 0.2f
