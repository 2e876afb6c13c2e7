package badlog.cli.convert

import badlog.analysis.periodicTimes
import badlog.analysis.resampled
import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.LogLoop
import badlog.cli.Outcome
import badlog.cli.Task
import badlog.cli.input.LogInput
import badlog.cli.input.readLog
import badlog.cli.output.FileName
import badlog.cli.output.LogFormat
import badlog.cli.output.OutputPlan
import badlog.cli.output.writeLog
import badlog.cli.text.counted
import badlog.cli.text.json
import badlog.cli.text.lossLines
import badlog.html.ExportProgress
import badlog.recording.RecordingFormat
import java.nio.file.Path
import kotlinx.serialization.json.JsonPrimitive

/**
 * Writes logs in another format.
 *
 * @param isGzip whether results are compressed though their logs were not.
 * @param xTopic the topic to make the x axis, or null.
 * @param period how far apart the rows are that a log without rows gets, in the unit of its x axis.
 */
internal class ConvertTask(
    private val paths: List<Path>,
    private val format: LogFormat,
    private val plan: OutputPlan,
    private val isGzip: Boolean,
    private val xTopic: String?,
    private val period: Double,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode = LogLoop("convert", console, isJson).run(paths, ::convert)

    private fun convert(input: LogInput, progress: ExportProgress): Outcome {
        val read = readLog(input.file, progress, xTopic)
        val recording = if (read.format == RecordingFormat.WPILOG) resampled(read, periodicTimes(read, period)) else read
        val name = FileName.of(input.file)
        val converted = name.with(format.ending, isGzip || name.isGzip)
        val target = plan.place(input, converted, converted)
        writeLog(recording, format, target, progress = progress)
        val leftOut = format.leftOut(recording)
        val rest = if (leftOut.isEmpty()) "" else "; without ${leftOut.joinToString()}"
        val text = listOf("${input.file} -> $target", "  ${counted(recording.rowCount.toLong(), "row")}$rest") +
            lossLines(recording.problems)
        val json = mapOf(
            "output" to JsonPrimitive(target.toString()),
            "format" to JsonPrimitive(format.option),
            "rows" to JsonPrimitive(recording.rowCount),
            "leftOut" to json(leftOut),
        )
        return Outcome(recording.isSalvaged, text.joinToString("\n"), json)
    }
}
