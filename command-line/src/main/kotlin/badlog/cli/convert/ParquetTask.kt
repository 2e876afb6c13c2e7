package badlog.cli.convert

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogInput
import badlog.cli.output.Omissions
import badlog.cli.output.OutputPlan
import badlog.cli.plugin.ParquetSession
import badlog.cli.plugin.PluginLoader
import badlog.cli.plugin.SeasonException
import badlog.cli.plugin.SeasonService
import badlog.cli.search.signalsBeside
import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import badlog.cli.text.lossLines
import badlog.cli.text.undefinedLines
import badlog.cli.topic.TopicChoice
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.files.terminal.Progress
import badlog.formats.wpilog.Omission
import badlog.report.UndefinedJson
import kotlinx.serialization.Serializable
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString

/**
 * Writes logs as Parquet files, each with the same columns as in `badlog lake`.
 *
 * @param virtualTopics definitions of topics to add.
 * @param only the topics to write.
 */
internal class ParquetTask(
    private val paths: List<Path>,
    private val plan: OutputPlan,
    private val virtualTopics: List<String>,
    private val only: TopicChoice,
    private val parts: PluginLoader,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode = parts.call("convert --to $OPTION", SeasonService::class.java, console) { service ->
        service.parquet().use { session ->
            LogLoop("convert", console, isJson, opensMatches = true).run(paths) { input, progress -> convert(session, input, progress) }
        }
    }

    private fun convert(session: ParquetSession, input: LogInput, progress: Progress): Outcome {
        val file = input.file
        val log = LogToConvert(input, virtualTopics, only, progress = progress)
        val name = log.name.with(ENDING, isGzip = false)
        val target = plan.place(input, name, name)
        val view = LogView.of(log.wanted)
        val files = try {
            session.write(view, input.relativePath.invariantSeparatorsPathString, file.fileName.toString(), signalsBeside(file), target)
        } catch (e: SeasonException) {
            throw Failure(e.message)
        }
        if (files.isEmpty()) throw Failure("$file: it has no samples to write.")
        // Paths as they were typed.
        val written = files.map { (path, rows) -> target.resolveSibling(path.fileName) to rows }
        val leftOut = omissionsOfNaN(log.wanted)
        val text = written.flatMap { (path, rows) -> listOf("$file -> $path", "  ${counted(rows, "row")}") } +
            leftOut.lines + undefinedLines(log.all.errors) + lossLines(log.wanted.problems)
        val rows = written.sumOf { it.second }
        val json = ParquetJson(written.first().first.toString(), OPTION, rows, leftOut.all, log.all.errors.map(::UndefinedJson))
        return Outcome(log.wanted.isSalvaged, text.joinToString("\n"), jsonOf(json))
    }

    /** Returns the samples of [recording] that are NaN: in a table, they would spoil every mean and maximum. */
    private fun omissionsOfNaN(recording: Recording): Omissions {
        val all = recording.topics.associate { it.name to it.counts.notFinite - it.samples.count(Double::isInfinite) }
        val found = all.filterValues { it > 0 }
        return Omissions(omissions = found.map { (name, count) -> Omission(name, "NaN is written as null.", count) })
    }

    companion object {
        /** Its name for `--to`. */
        const val OPTION = "parquet"

        /** The ending of such files. */
        const val ENDING = ".parquet"
    }
}

@Serializable
private class ParquetJson(
    private val output: String,
    private val format: String,
    private val rows: Long,
    private val leftOut: List<String>,
    private val undefined: List<UndefinedJson>,
)
