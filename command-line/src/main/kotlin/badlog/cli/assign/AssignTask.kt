package badlog.cli.assign

import badlog.catalog.folder.SignalAssignment
import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.cli.input.Failure
import badlog.cli.input.readLog
import badlog.cli.search.signalsBeside
import badlog.cli.text.jsonOf
import badlog.core.analysis.LogView
import badlog.files.requireRegularFile
import badlog.rules.SignalsFile
import badlog.signals.withSignals
import kotlinx.serialization.Serializable
import java.nio.file.Files
import java.nio.file.Path

/**
 * Makes [topic] the signal [signal] in all logs beside [log].
 *
 * @param near returns the names that are similar to a misspelled one.
 */
internal class AssignTask(
    private val log: Path,
    private val signal: String,
    private val topic: String,
    private val near: (String, List<String>) -> List<String>,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val folder = log.toAbsolutePath().normalize().parent
        val isNew = !Files.exists(folder.resolve(SignalsFile.NAME))
        val written = try {
            assign(console)
        } catch (e: Exception) {
            return Outcomes("assign", console, isJson).run {
                failed(log, LogLoop.sentenceOf(e, log))
                end()
            }
        }
        val above = generateSequence(folder.parent) { it.parent }.map { it.resolve(SignalsFile.NAME) }.firstOrNull(Files::isRegularFile)
        if (isNew && above != null) {
            console.warn("$above also names signals. The window uses only the nearest file; copy the names that you need into it.")
        }
        console.say(
            if (isJson) {
                Spelling.ascii("${jsonOf(AssignedJson("assign", "$log", "whole", "$written", signal, topic))}")
            } else {
                "“$signal” is “$topic” in all logs of $folder, as $written now says."
            },
        )
        return ExitCode.WHOLE
    }

    /** Returns the file that it is written in. */
    private fun assign(console: Console): Path {
        requireRegularFile(log)
        val vocabulary = signalsBeside(log)
        if (vocabulary.find(signal) == null) {
            val known = vocabulary.signals.map { it.name }
            throw Failure("“$signal” is not a signal${suggestionFor(signal, known, "badlog info --signals")}")
        }
        val recording = console.progress("${log.fileName}").use { readLog(log, it) }
        val topics = recording.topics.map { it.name }
        if (topic !in topics) throw Failure("“$topic” is not a topic of $log${suggestionFor(topic, topics, "badlog info --topics")}")
        val assignment = SignalAssignment(log, library = null)
        assignment.assign(signal, topic, LogView.of(recording).withSignals(vocabulary, log.fileName.toString()))?.let { throw Failure(it) }
        return assignment.file
    }

    private fun suggestionFor(name: String, known: List<String>, list: String): String {
        val meant = near(name, known).take(MAX_MEANT).joinToString(" or ") { "“$it”" }
        return if (meant.isEmpty()) "; $list shows them." else "; did you mean $meant?"
    }
}

/** The assignment, for programs. */
@Serializable
private class AssignedJson(
    private val command: String,
    private val file: String,
    private val status: String,
    private val output: String,
    private val signal: String,
    private val topic: String,
)

private const val MAX_MEANT = 2
