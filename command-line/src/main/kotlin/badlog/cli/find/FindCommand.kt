package badlog.cli.find

import badlog.catalog.match.MatchMaker
import badlog.cli.command.ExitCode
import badlog.cli.command.LogCommand
import badlog.cli.command.LogFiles
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.command.VirtualTopicOption
import badlog.cli.console.Console
import badlog.cli.merge.LeftOutLogs
import badlog.cli.search.rulesBeside
import badlog.cli.text.jsonOf
import badlog.files.UserFolders
import badlog.report.Find
import badlog.report.FindJson
import badlog.report.FindResult
import badlog.report.Reply
import badlog.report.findText
import badlog.report.mistakeIn
import badlog.report.undefinedTexts
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Path

internal class FindCommand :
    LogCommand(
        "find",
        "Answers a question for every log.",
        "The question is an expression, such as 'min(System/Battery Voltage) < 7'. Answers are cached: " +
            "a log that has not changed is not read again.",
    ) {
    private val question by argument("QUESTION").help("An expression over the topics of a log.")
    private val virtual by VirtualTopicOption()
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis; CSV does not name one.")
    private val isFresh by option("--no-cache").flag().help("Read every log again, and store no results.")

    override val examples: List<String> = listOf(
        "find logs \"min(battery voltage) < 7\"",
        "find logs \"mean(total current) by state\"",
        "find logs \"max(total current) highest 3\" --json",
    )

    override val words: List<String> get() = super.words + question

    override fun makeTask(): Task =
        FindTask(paths, question, virtual.definitions, if (isFresh) null else UserFolders.ofSystem().answers, xTopic, isJson)
}

/**
 * Evaluates [question] for every log below [paths].
 *
 * @param virtualTopics definitions of topics that it may use in addition to the logs' own.
 * @param cache the folder for cached answers; null for none.
 * @param xTopic the topic to use as x axis, or null.
 */
internal class FindTask(
    private val paths: List<Path>,
    private val question: String,
    private val virtualTopics: List<String>,
    private val cache: Path?,
    private val xTopic: String?,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val made = LeftOutLogs(MatchMaker)
        val find = Find(question, virtualTopics, cache, xTopic, rulesBeside(paths, console::warn).signals, made)
        find.mistake?.let {
            console.warn(it.pointed)
            return ExitCode.USAGE
        }
        val logs = LogFiles(paths, console, opensMatches = true)
        val results = console.progress("find").use { bar ->
            find.over(logs.files, { done, total -> bar.advanced(done.toLong(), total.toLong()) })
        }
        val mistake = mistakeIn(results)
        if (mistake != null) {
            // A topic missing in the question may be one that could not be calculated.
            undefinedTexts(results.filter { it.reply is Reply.NotAsked }.map { it.undefined }).forEach(console::warn)
            console.warn(mistake.pointed)
            return ExitCode.USAGE
        }
        val asked = results.filter { (it.reply as? Reply.Unreadable)?.isNoLog != true }
        if (!isJson && asked.isNotEmpty()) console.say(findText(asked, console.width))
        val outcomes = Outcomes("find", console, isJson)
        val resultOf = results.associateBy { it.file }
        logs.report(outcomes) { input, file ->
            val result = resultOf.getValue(file)
            when (val reply = result.reply) {
                is Reply.Unreadable -> outcomes.unreadable(input, reply.message, reply.isNoLog)

                else -> {
                    if (!isJson) made.of(file.path).forEach { console.warn("${file.path}: $it") }
                    val json = if (isJson) jsonOf(FindJson(result)) + made.jsonOf(file.path) else emptyMap()
                    outcomes.done(input.file, Outcome(result.isSalvaged, "", json))
                }
            }
        }
        return outcomes.end()
    }
}
