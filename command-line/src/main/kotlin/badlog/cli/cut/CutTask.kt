package badlog.cli.cut

import badlog.analysis.LogView
import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.Failure
import badlog.cli.LogLoop
import badlog.cli.Outcome
import badlog.cli.Task
import badlog.cli.input.LogInput
import badlog.cli.input.readRows
import badlog.cli.output.FileName
import badlog.cli.output.LogFormat
import badlog.cli.output.OutputPlan
import badlog.cli.output.writeLog
import badlog.cli.text.XTime
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.json
import badlog.cli.text.lossLines
import badlog.html.ExportProgress
import java.nio.file.Path
import java.util.BitSet
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * Writes a part of each log.
 *
 * @param choices what to keep: the rows that all of them choose.
 * @param xTopic the topic to take as x axis, or null.
 */
internal class CutTask(
    private val paths: List<Path>,
    private val choices: List<RowChoice>,
    private val plan: OutputPlan,
    private val xTopic: String?,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode = LogLoop("cut", console, isJson).run(paths, ::cut)

    private fun cut(input: LogInput, progress: ExportProgress): Outcome {
        val view = LogView.of(readRows(input.file, progress, xTopic))
        val recording = view.recording
        val runs = try {
            choose(view).runs()
        } catch (e: Failure) {
            throw Failure("${input.file}: ${e.message}")
        }
        val target = plan.place(input, FileName.of(input.file).marked("cut"), input.file.fileName.toString())
        val format = plan.file?.let(LogFormat::ofName) ?: LogFormat.of(recording)
        writeLog(recording, format, target, runs, progress)
        val leftOut = format.leftOut(recording)
        val text = text(view, "${input.file} -> $target", runs, leftOut)
        return Outcome(recording.isSalvaged, text, json(view, target, runs) + mapOf("leftOut" to json(leftOut)))
    }

    private fun choose(view: LogView): BitSet {
        val x = view.xAxis.positions
        val rows = BitSet(x.size).apply { set(0, x.size) }
        for (choice in choices) rows.and(rowsIn(x, choice.spans(view)))
        if (!rows.isEmpty) return rows
        val finite = x.filter { it.isFinite() }
        if (finite.isEmpty()) throw Failure("it has no rows to keep any of.")
        val unit = view.xAxis.unit
        val range = "from ${XTime.text(finite.min(), unit)} to ${XTime.text(finite.max(), unit)}"
        throw Failure("no row lies there; ${view.xAxis.name} goes $range.")
    }

    private fun text(view: LogView, title: String, runs: List<IntRange>, leftOut: List<String>): String {
        val without = if (leftOut.isEmpty()) "" else "; without ${leftOut.joinToString()}"
        val lines = runs.take(LISTED).map { run ->
            val from = XTime.text(view.xAxis.positions[run.first], view.xAxis.unit)
            "  from $from to ${XTime.text(view.xAxis.positions[run.last], view.xAxis.unit)}"
        }
        val more = if (runs.size > LISTED) listOf("  and ${runs.size - LISTED} more") else emptyList()
        val kept = "  kept ${grouped(countOf(runs).toLong())} of ${counted(view.recording.rowCount.toLong(), "row")}$without"
        return (listOf(title, kept) + lines + more + lossLines(view.problems)).joinToString("\n")
    }

    private fun json(view: LogView, target: Path, runs: List<IntRange>) = mapOf(
        "output" to JsonPrimitive(target.toString()),
        "rows" to JsonPrimitive(countOf(runs)),
        "ofRows" to JsonPrimitive(view.recording.rowCount),
        "parts" to JsonArray(
            runs.map {
                JsonObject(mapOf("from" to json(view.xAxis.positions[it.first]), "to" to json(view.xAxis.positions[it.last])))
            },
        ),
    )

    private fun countOf(runs: List<IntRange>) = runs.sumOf { it.count() }

    private companion object {
        const val LISTED = 10
    }
}
