package badlog.cli.cut

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogInput
import badlog.cli.input.readLog
import badlog.cli.output.Omissions
import badlog.cli.output.OutputFormat
import badlog.cli.output.OutputPlan
import badlog.cli.output.copyRecords
import badlog.cli.output.isEvent
import badlog.cli.output.recordsOf
import badlog.cli.output.topicOf
import badlog.cli.output.writeLog
import badlog.cli.search.signalsBeside
import badlog.cli.text.StretchJson
import badlog.cli.text.XTime
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.jsonOf
import badlog.cli.text.lossLines
import badlog.cli.text.wrapped
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Recording
import badlog.core.recording.Value
import badlog.files.terminal.Progress
import badlog.rules.ofPart
import badlog.signals.withSignals
import kotlinx.serialization.Serializable
import java.nio.file.Path

/**
 * Writes a part of each log.
 *
 * @param choices the choices of parts; their intersection is kept.
 * @param xTopic the topic to use as x axis; null for the log's own.
 */
internal class CutTask(
    private val paths: List<Path>,
    private val choices: List<PartChoice>,
    private val plan: OutputPlan,
    private val xTopic: String?,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode = LogLoop("cut", console, isJson).run(paths, ::cut)

    private fun cut(input: LogInput, progress: Progress): Outcome {
        val view = LogView.of(readLog(input.file, progress, xTopic)).withSignals(signalsBeside(input.file), input.file.fileName.toString())
        val part = try {
            partOf(view)
        } catch (e: Failure) {
            throw Failure("${input.file}: ${e.message}")
        }
        val name = OutputFormat.nameFor(input.file, view.recording)
        val target = plan.place(input, name.marked("cut"), name.toString())
        val format = plan.file?.let(OutputFormat::ofName) ?: OutputFormat.of(view.recording)
        val said = spansText(part.spans, view.xAxis.unit)
        val leftOut = write(view.recording, part, said, format, input.file, target, progress)
        val text = text(view, "${input.file} -> $target", part, leftOut)
        return Outcome(view.recording.isSalvaged, text, jsonOf(json(view, target, part, leftOut)))
    }

    private fun partOf(view: LogView): CutPart {
        val spans = choices.map { joined(it.spans(view)) }.reduce(::intersection)
        return if (view.recording.format.hasRows) rowPart(view, spans) else samplePart(view, spans)
    }

    /** Returns its place on the x axis for people. */
    private fun spansText(spans: List<Span>, unit: String): String {
        val first = spans.take(LISTED).joinToString { "${XTime.text(it.from, unit)} to ${XTime.text(it.to, unit)}" }
        return if (spans.size > LISTED) "$first and ${spans.size - LISTED} more" else first
    }

    private fun write(
        whole: Recording,
        part: CutPart,
        said: String,
        format: OutputFormat,
        file: Path,
        target: Path,
        progress: Progress,
    ): Omissions {
        if (format.hasRows || !whole.format.hasRecords) {
            val recording = part.recording.run { if (format == OutputFormat.CSV) this else copy(values = values.ofPart(said)) }
            return writeLog(recording, format, target, part.rows, progress = progress)
        }
        copyRecords(recordsOf(file), target, progress) {
            spans(part.spans, whole::isEvent, emptyList<Value>().ofPart(said)) { entry ->
                // Few events may look like states.
                part.recording.topicOf(entry)?.takeIf { it.attributes != whole.topicOf(entry)?.attributes }
            }
        }
        return Omissions()
    }

    private fun text(view: LogView, title: String, part: CutPart, leftOut: Omissions): String {
        val unit = view.xAxis.unit
        val lines = part.spans.take(LISTED).map { "  from ${XTime.text(it.from, unit)} to ${XTime.text(it.to, unit)}" }
        val more = if (part.spans.size > LISTED) listOf("  and ${part.spans.size - LISTED} more") else emptyList()
        val kept = if (view.recording.format.hasRows) {
            "${grouped(part.rowCount.toLong())} of ${counted(view.recording.rowCount.toLong(), "row")}"
        } else {
            "${grouped(part.sampleCount)} of ${counted(view.recording.sampleCount, "sample")}"
        }
        val head = listOf(title, wrapped("  ", "kept $kept${leftOut.tail}", INDENT))
        return (head + lines + more + leftOut.lines + lossLines(view.problems)).joinToString("\n")
    }

    private fun json(view: LogView, target: Path, part: CutPart, leftOut: Omissions) = CutJson(
        target.toString(),
        part.rowCount,
        view.recording.rowCount,
        part.sampleCount,
        view.recording.sampleCount,
        part.spans.map { StretchJson(it.from, it.to) },
        leftOut.all,
    )
}

@Serializable
private class CutJson(
    private val output: String,
    private val rows: Int,
    private val ofRows: Int,
    private val samples: Long,
    private val ofSamples: Long,
    private val parts: List<StretchJson>,
    private val leftOut: List<String>,
)

private const val LISTED = 10
private const val INDENT = 4
