package badlog.cli.info

import badlog.catalog.examine.UndefinedTopic
import badlog.catalog.match.MatchMaker
import badlog.cli.beside.FilesBeside
import badlog.cli.command.ExitCode
import badlog.cli.command.LogCommand
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Task
import badlog.cli.command.VirtualTopicOption
import badlog.cli.console.Console
import badlog.cli.input.readLog
import badlog.cli.merge.MatchChoice
import badlog.cli.merge.MatchOptions
import badlog.cli.merge.matched
import badlog.cli.search.signalsBeside
import badlog.cli.text.jsonOf
import badlog.cli.topic.OnlyOption
import badlog.cli.topic.TopicChoice
import badlog.core.analysis.LogView
import badlog.files.LogFile
import badlog.files.LogMaker
import badlog.report.NamedTopics
import badlog.report.undefinedTexts
import badlog.signals.clock.ClockedLog
import badlog.signals.signalTopicsOf
import badlog.signals.withSignals
import badlog.signals.withVirtualTopics
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Files
import java.nio.file.Path

internal class InfoCommand :
    LogCommand(
        "info",
        "Shows what is in logs.",
        "Of one log: match, x axis, values, topics and problems; of several, one line each. HZ is samples per " +
            "second. A WPILOG is held in memory while it is read, 8 bytes a number.",
    ) {
    private val showsTopics by option("--topics").flag().help("Show the topics, of several logs too.")
    private val showsAttributes by option("--attributes").flag().help("Show the topics with their attributes.")
    private val showsSignals by option("--signals").flag().help("Show which topic is which signal, such as the battery.")
    private val showsValues by option("--values").flag().help("Show the values, of several logs too.")
    private val showsProblems by option("--problems").flag().help("Show the problems, of several logs too.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis; CSV does not name one.")
    private val virtual by VirtualTopicOption()
    private val only by OnlyOption()
    private val match by MatchOptions()

    override val examples: List<String> = listOf(
        "info logs",
        "info match.bag --only \"*battery voltage\"",
        "info logs --problems",
        "info match.zip",
    )

    override fun makeTask(): Task {
        val parts = buildSet {
            if (showsTopics || showsAttributes || !only.choice.isAll) add(InfoPart.TOPICS)
            if (showsAttributes) add(InfoPart.ATTRIBUTES)
            if (showsSignals) add(InfoPart.SIGNALS)
            if (showsValues) add(InfoPart.VALUES)
            if (showsProblems) add(InfoPart.PROBLEMS)
        }
        if (xTopic != null && match.isOne) throw UsageError("--x cannot be used together with --align or --offset; merge the logs first")
        return InfoTask(paths, parts, xTopic, virtual.definitions, only.choice, isJson, match.choice(paths, isJson))
    }
}

/** The parts that can be shown of a log besides its summary. */
internal enum class InfoPart {
    /** A table of the topics. */
    TOPICS,

    /** The attributes of each topic, below it. */
    ATTRIBUTES,

    /** The topics that were recognized as signals. */
    SIGNALS,

    /** The values. */
    VALUES,

    /** The problems of the file, without notes. */
    WORST,

    /** All problems of the file, including notes. */
    PROBLEMS,
}

/**
 * Shows the content of logs.
 *
 * @param parts the parts to show; empty for everything about a single log, or one line for each of several.
 * @param xTopic the topic to use as x axis, or null.
 * @param virtualTopics definitions of topics to add.
 * @param only the topics to show.
 * @param match the choice of logs that are read as one.
 */
internal class InfoTask(
    private val paths: List<Path>,
    private val parts: Set<InfoPart>,
    private val xTopic: String?,
    private val virtualTopics: List<String>,
    private val only: TopicChoice,
    private val isJson: Boolean,
    private val match: MatchChoice = MatchChoice.AsTheyAre,
) : Task {
    override fun run(console: Console): ExitCode = matched("info", paths, match, console, isJson, ::run)

    private fun run(paths: List<Path>, maker: LogMaker, console: Console): ExitCode {
        val isFolder = Files.isDirectory(paths[0]) && MatchMaker.manifestIn(paths[0]) == null
        val isOverview = !isJson && parts.isEmpty() && (paths.size > 1 || isFolder)
        val shown = parts.ifEmpty { setOf(InfoPart.TOPICS, InfoPart.VALUES, InfoPart.WORST) }
        val overview = OverviewText(console.width)
        val files = FilesBeside()
        var isFirst = true
        val undefined = ArrayList<List<UndefinedTopic>>()
        val code = LogLoop("info", console, isJson, opensMatches = true).run(paths) { input, progress ->
            val vocabulary = signalsBeside(input.file)
            val numbers = StreamedNumbers(NamedTopics(virtualTopics, xTopic, vocabulary.namedIn(virtualTopics.joinToString("\n"))))
            val recording = readLog(input.file, progress, xTopic, numbers, maker)
            val view = LogView.of(recording).withSignals(vocabulary, input.file.fileName.toString())
            val with = view.withVirtualTopics(virtualTopics, vocabulary)
            val signals = signalTopicsOf(with.view, vocabulary).all
            val summary = LogSummary(input.file, LogFile.of(input.file).size, with.view, numbers, only)
            val log = ClockedLog(input.file.fileName.toString(), recording, vocabulary)
            val beside = if (isOverview) emptyList() else files.of(input.file, log)
            val text = when {
                isJson -> ""
                isOverview -> overview.add(summary)
                else -> (if (isFirst) "" else "\n") + InfoText(summary, shown, signals, console.width, beside).text()
            }
            isFirst = false
            undefined += with.errors.map(::UndefinedTopic)
            val json = if (isJson) jsonOf(InfoJson(summary, signals, with.errors)) + files.jsonOf(beside) else emptyMap()
            Outcome(recording.isSalvaged, text, json)
        }
        overview.rest().let { if (it.isNotEmpty()) console.say(it) }
        if (!isJson) undefinedTexts(undefined).forEach(console::say)
        return code
    }
}
