package badlog.cli.export

import badlog.analysis.LogView
import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.LogInput
import badlog.cli.input.NotALog
import badlog.cli.output.OutputPlan
import badlog.cli.search.Search
import badlog.cli.search.SearchException
import badlog.cli.text.counted
import badlog.cli.text.json
import badlog.cli.text.lossLines
import badlog.cli.text.undefinedLines
import badlog.cli.text.wrapped
import badlog.expression.undefinedTopics
import badlog.file.UnreadableFileException
import badlog.file.requireRegularFile
import badlog.html.ExportException
import badlog.html.HtmlExporter
import badlog.html.PageAdditions
import badlog.report.failureJson
import badlog.rules.RulesFile
import badlog.rules.SkippedRule
import badlog.report.skippedJson
import badlog.report.undefinedJson
import badlog.terminal.Progress
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Path

/**
 * Makes a page of each log, one after the other: each takes all cores by itself.
 *
 * @param search what to look for in the logs, and show in their pages.
 */
internal class ExportTask(
    private val paths: List<Path>,
    private val plan: OutputPlan,
    private val attachments: List<Path>,
    private val search: Search,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        try {
            attachments.forEach(::requireRegularFile)
        } catch (e: UnreadableFileException) {
            console.warn(e.message)
            return ExitCode.NOTHING
        }
        val rules = try {
            search.namedRules() ?: RulesFile.NONE
        } catch (e: SearchException) {
            console.warn(e.message)
            return ExitCode.USAGE
        }
        val exporter = HtmlExporter(attachments)
        val refused = ArrayList<List<SkippedRule>>()
        val code = LogLoop("export", console, isJson).run(paths) { input, progress ->
            // Only what looks for something reads a log before it is in a page.
            if (search.isEmpty) return@run export(exporter, input, null, progress)
            val found = Found.of(input.file, rules.rules, search.hooksWith(rules), search.virtualTopics) { done, total ->
                progress.advanced(done, total * 2)
            }
            if (found.unreadable == null) refused += found.skipped
            export(exporter, input, found) { done, total -> progress.advanced(total + done, total * 2) }
        }
        return if (search.neverAsked(refused).any { it.isMistake }) ExitCode.USAGE else code
    }

    private fun export(exporter: HtmlExporter, input: LogInput, found: Found?, progress: Progress): Outcome {
        val name = "${input.file.fileName}.html"
        val target = plan.place(input, name, name)
        val additions = found?.additions(search.virtualTopics) ?: PageAdditions(search.virtualTopics)
        val report = try {
            exporter.export(input.file, target, additions, progress)
        } catch (e: ExportException.NotARecording) {
            throw NotALog(e.message.orEmpty())
        }
        val undefined = undefinedTopics(LogView.of(report.recording), search.virtualTopics)
        val failures = found?.failures.orEmpty()
        val skipped = found?.skipped.orEmpty()
        val text = listOf("${input.file} -> $target") +
            listOfNotNull(found?.let(::findingsText)) +
            search.toldOf(skipped).flatMap { it.toString().lines() }.map { "  $it" } +
            undefinedLines(undefined) +
            failures.map { (hook, failure) -> wrapped("  ", "hook “$hook”: ${failure.message}") } +
            lossLines(report.recording.problems)
        val json = mapOf(
            "output" to JsonPrimitive(target.toString()),
            "rows" to JsonPrimitive(report.recording.rowCount),
            "findings" to JsonPrimitive(found?.count),
            "findingsError" to JsonPrimitive(found?.unreadable),
            "notAsked" to JsonArray(skipped.map(::skippedJson)),
            "undefined" to undefinedJson(undefined),
            "hookFailures" to JsonArray(failures.map { (hook, failure) -> failureJson(hook, failure.message) }),
            "problems" to JsonArray(report.recording.problems.map { json(it) }),
        )
        val isIncomplete = failures.isNotEmpty() || found?.unreadable != null || search.toldOf(skipped).isNotEmpty()
        return Outcome(report.recording.isSalvaged || isIncomplete, text.joinToString("\n"), json)
    }

    private fun findingsText(found: Found): String = when (val reason = found.unreadable) {
        null -> "  " + counted(found.count.toLong(), "finding")
        else -> wrapped("  ", "nothing was looked for: $reason")
    }
}
