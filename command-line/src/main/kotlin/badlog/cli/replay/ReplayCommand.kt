package badlog.cli.replay

import badlog.cli.command.ExitCode
import badlog.cli.command.LogCommand
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.command.VirtualTopicOption
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.Position
import badlog.cli.input.position
import badlog.cli.input.readLog
import badlog.cli.output.recordsOf
import badlog.cli.output.topicOf
import badlog.cli.search.signalsBeside
import badlog.cli.text.jsonOf
import badlog.cli.text.shortNumber
import badlog.cli.text.undefinedLines
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.networktables.replay.LoggedTopic
import badlog.networktables.replay.ReplayOptions
import badlog.networktables.replay.ReplayServer
import badlog.networktables.replay.UnavailablePortException
import badlog.report.UndefinedJson
import badlog.signals.withSignals
import badlog.signals.withVirtualTopics
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.validate
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.restrictTo
import kotlinx.serialization.Serializable
import java.nio.file.Path

internal class ReplayCommand :
    LogCommand(
        "replay",
        "Replays a log to dashboards, in real time.",
        "Runs an NT4 server on this computer, like the robot's; Ctrl+C ends it. docs/replay.md shows how dashboards connect.",
        logHelp = "The log.",
    ) {
    private val port by option("--port", metavar = "N").int().restrictTo(0..MAX_PORT).default(ReplayOptions.DEFAULT_PORT)
        .help("Port; default: ${ReplayOptions.DEFAULT_PORT}.")
    private val speed by option("--speed", metavar = "FACTOR").double().default(1.0)
        .help("Speed: 2 is twice real time; default: 1.")
        .validate { if (!(it > 0 && it.isFinite())) fail("must be above 0") }
    private val isLooping by option("--loop").flag().help("Start over at the end.")
    private val prefix by option("--prefix", metavar = "NAME").default("").help("Put this before all names, such as /old.")
    private val from by option("--from", metavar = "X").position().help("Start at this x, 90 or 1:30.")
    private val to by option("--to", metavar = "X").position().help("End at this x.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis; CSV does not name one.")
    private val virtual by VirtualTopicOption()

    override val examples: List<String> = listOf(
        "replay match.bag",
        "replay match.bag --from 1:30 --speed 0.5 --loop",
    )

    override fun makeTask(): Task {
        val file = paths.singleOrNull() ?: throw UsageError("name one log to replay")
        val optionsFor = { range: ClosedFloatingPointRange<Double>? ->
            ReplayOptions(port, speed = speed, isLooping = isLooping, range = range, prefix = prefix)
        }
        return ReplayTask(file, optionsFor, from, to, xTopic, virtual.definitions, isJson)
    }
}

/**
 * Serves [file] with [virtualTopics] to dashboards until its end, or, if it is looping, until the program is ended.
 *
 * @param optionsFor returns the options for a range of the log; null for all of it.
 * @param xTopic the topic to use as x axis; null for the log's own.
 */
internal class ReplayTask(
    private val file: Path,
    private val optionsFor: (ClosedFloatingPointRange<Double>?) -> ReplayOptions,
    private val from: Position?,
    private val to: Position?,
    private val xTopic: String?,
    private val virtualTopics: List<String>,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val outcomes = Outcomes("replay", console, isJson)
        try {
            val recording = console.progress(file.fileName.toString()).use { readLog(file, it, xTopic) }
            val signals = signalsBeside(file)
            val with = LogView.of(recording).withSignals(signals, file.fileName.toString()).withVirtualTopics(virtualTopics, signals)
            if (!isJson) undefinedLines(with.errors).forEach(console::warn)
            ReplayServer(with.view, optionsFor(rangeOn(with.view)), loggedTopics(recording)).use { server ->
                server.start()
                val json = jsonOf(ReplayJson(server.port, with.errors.map(::UndefinedJson)))
                outcomes.done(file, Outcome(recording.isSalvaged, text(server.port), json))
                play(server, console)
            }
        } catch (e: UnavailablePortException) {
            outcomes.failed(file, e.message.orEmpty())
        } catch (e: Exception) {
            outcomes.failed(file, LogLoop.sentenceOf(e, file))
        } catch (e: OutOfMemoryError) {
            outcomes.failed(file, LogLoop.sentenceOf(e, file))
        }
        return outcomes.end()
    }

    /** Returns, for a WPILOG, the content of its records that its topics do not have: structs, arrays, raw bytes. */
    private fun loggedTopics(recording: Recording): List<LoggedTopic> {
        if (!recording.format.hasRecords) return emptyList()
        return recordsOf(file).entries.filter { !it.isValue }.map { entry ->
            val times = DoubleArray(entry.size, entry::time)
            LoggedTopic(entry.name, entry.type, recording.topicOf(entry)?.unit.orEmpty(), times, entry::payload)
        }
    }

    private fun text(port: Int): String {
        val served = "$file is served on port $port; Ctrl+C ends it."
        return if (port == ReplayOptions.DEFAULT_PORT) {
            served
        } else {
            "$served\nAdvantageScope, Elastic and Shuffleboard only look at port ${ReplayOptions.DEFAULT_PORT}; they will not find it."
        }
    }

    private fun rangeOn(view: LogView): ClosedFloatingPointRange<Double>? {
        val whole = view.xAxis.range
        if ((from == null && to == null) || whole == null) return null
        val start = from?.on(view.xAxis) ?: whole.start
        val end = to?.on(view.xAxis) ?: whole.endInclusive
        if (start > end || start > whole.endInclusive || end < whole.start) {
            val asked = listOfNotNull(from?.let { "from $it" }, to?.let { "to $it" }).joinToString(" ")
            val x = "${view.xAxis.title} goes from ${shortNumber(whole.start)} to ${shortNumber(whole.endInclusive)}"
            val why = if (start > end && from != null && to != null) "--from $from comes after --to $to" else "$file has nothing $asked"
            throw Failure("$why; $x. Use another --from or --to.")
        }
        return start..end
    }

    private fun play(server: ReplayServer, console: Console) {
        var known = emptyList<String>()
        var note: String? = null
        var refusal: String? = null
        while (server.options.isLooping || !server.isAtEnd) {
            Thread.sleep(LOOK_MILLIS)
            // Once, not for each further message.
            if (note == null) note = server.note?.also(console::warn)
            if (refusal == null) refusal = server.refusal?.also(console::warn)
            val clients = server.clientNames
            for (name in clients - known.toSet()) console.warn("$name is connected.")
            for (name in known - clients.toSet()) console.warn("$name disconnected.")
            known = clients
        }
        // The last values are still being sent.
        Thread.sleep(LOOK_MILLIS)
        server.note?.takeIf { it != note }?.let(console::warn)
    }
}

@Serializable
private class ReplayJson(private val port: Int, private val undefined: List<UndefinedJson>)

private const val MAX_PORT = 65_535

private const val LOOK_MILLIS = 200L
