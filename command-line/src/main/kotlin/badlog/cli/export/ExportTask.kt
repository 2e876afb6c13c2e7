package badlog.cli.export

import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.LogLoop
import badlog.cli.Outcome
import badlog.cli.Task
import badlog.cli.input.LogInput
import badlog.cli.input.NotALog
import badlog.cli.output.OutputPlan
import badlog.cli.text.json
import badlog.cli.text.lossLines
import badlog.file.UnreadableFileException
import badlog.file.requireRegularFile
import badlog.html.ExportException
import badlog.html.ExportProgress
import badlog.html.HtmlExporter
import java.nio.file.Path
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonPrimitive

/** Makes a page of each log, one after the other: each takes all cores by itself. */
internal class ExportTask(
    private val paths: List<Path>,
    private val plan: OutputPlan,
    private val attachments: List<Path>,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        try {
            attachments.forEach(::requireRegularFile)
        } catch (e: UnreadableFileException) {
            console.err.println(e.message)
            return ExitCode.NOTHING
        }
        val exporter = HtmlExporter(attachments)
        return LogLoop("export", console, isJson).run(paths) { input, progress -> export(exporter, input, progress) }
    }

    private fun export(exporter: HtmlExporter, input: LogInput, progress: ExportProgress): Outcome {
        val name = "${input.file.fileName}.html"
        val target = plan.place(input, name, name)
        val report = try {
            exporter.export(input.file, target, progress = progress)
        } catch (e: ExportException.NotARecording) {
            throw NotALog(e.message.orEmpty())
        }
        val text = listOf("${input.file} -> $target") + lossLines(report.recording.problems)
        val json = mapOf(
            "output" to JsonPrimitive(target.toString()),
            "rows" to JsonPrimitive(report.recording.rowCount),
            "problems" to JsonArray(report.recording.problems.map { json(it) }),
        )
        return Outcome(report.recording.isSalvaged, text.joinToString("\n"), json)
    }
}
