package badlog.cli.info

import badlog.analysis.LogView
import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.LogLoop
import badlog.cli.Outcome
import badlog.cli.Task
import badlog.cli.input.readLog
import badlog.expression.withVirtualTopics
import badlog.report.UndefinedTopic
import badlog.report.undefinedJson
import badlog.report.undefinedTexts
import java.nio.file.Files
import java.nio.file.Path

/**
 * Says what is in logs.
 *
 * @param parts what to show; empty for all of one log, and for one line of each of several.
 * @param xTopic the topic to take as x axis, or null.
 * @param virtualTopics definitions of topics to add.
 */
internal class InfoTask(
    private val paths: List<Path>,
    private val parts: Set<InfoPart>,
    private val xTopic: String?,
    private val virtualTopics: List<String>,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val isOverview = !isJson && parts.isEmpty() && (paths.size > 1 || Files.isDirectory(paths[0]))
        val shown = parts.ifEmpty { setOf(InfoPart.TOPICS, InfoPart.VALUES, InfoPart.WORST) }
        var isFirst = true
        val undefined = ArrayList<List<UndefinedTopic>>()
        val code = LogLoop("info", console, isJson).run(paths) { input, progress ->
            val recording = readLog(input.file, progress, xTopic)
            val with = LogView.of(recording).withVirtualTopics(virtualTopics)
            val summary = LogSummary(input.file, Files.size(input.file), with.view)
            val text = when {
                isJson -> ""
                isOverview -> (if (isFirst) OverviewText.titles() + "\n" else "") + OverviewText.line(summary)
                else -> (if (isFirst) "" else "\n") + InfoText(summary, shown).text()
            }
            isFirst = false
            undefined += with.errors.map(::UndefinedTopic)
            val json = if (isJson) infoJson(summary) + mapOf("undefined" to undefinedJson(with.errors)) else emptyMap()
            Outcome(recording.isSalvaged, text, json)
        }
        if (!isJson) undefinedTexts(undefined).forEach(console::say)
        return code
    }
}
