package badlog.cli.replay

import badlog.analysis.LogView
import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.Failure
import badlog.cli.LogLoop
import badlog.cli.Outcome
import badlog.cli.Outcomes
import badlog.cli.Task
import badlog.cli.analysis.undefinedLines
import badlog.cli.input.NotALog
import badlog.cli.input.Position
import badlog.cli.input.readLog
import badlog.cli.text.shortNumber
import badlog.expression.withVirtualTopics
import badlog.replay.ReplayOptions
import badlog.replay.ReplayServer
import badlog.replay.UnavailablePortException
import badlog.report.undefinedJson
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Path

/**
 * Serves [file] with [virtualTopics] to dashboards until its end, or, where it [isLooping], until the program is ended.
 *
 * @param xTopic the topic to take as x axis, or null.
 */
internal class ReplayTask(
    private val file: Path,
    private val port: Int,
    private val speed: Double,
    private val isLooping: Boolean,
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
            val with = LogView.of(recording).withVirtualTopics(virtualTopics)
            if (!isJson) undefinedLines(with.errors).forEach(console::warn)
            val options = ReplayOptions(port = port, speed = speed, isLooping = isLooping, range = rangeOn(with.view))
            ReplayServer(with.view, options).use { server ->
                server.start()
                val json = mapOf("port" to JsonPrimitive(server.port), "undefined" to undefinedJson(with.errors))
                outcomes.done(file, Outcome(recording.isSalvaged, "$file is served on port ${server.port}; Ctrl+C ends it.", json))
                play(server, console)
            }
        } catch (e: NotALog) {
            outcomes.failed(file, e.message)
        } catch (e: UnavailablePortException) {
            outcomes.failed(file, e.message.orEmpty())
        } catch (e: Exception) {
            outcomes.failed(file, LogLoop.sentenceOf(e, file))
        } catch (e: OutOfMemoryError) {
            outcomes.failed(file, LogLoop.sentenceOf(e, file))
        }
        return outcomes.end()
    }

    private fun rangeOn(view: LogView): ClosedFloatingPointRange<Double>? {
        val whole = view.xAxis.range
        if ((from == null && to == null) || whole == null) return null
        val start = from?.on(view.xAxis) ?: whole.start
        val end = to?.on(view.xAxis) ?: whole.endInclusive
        if (start > end || start > whole.endInclusive || end < whole.start) {
            val asked = listOfNotNull(from?.let { "from $it" }, to?.let { "to $it" }).joinToString(" ")
            val x = "${view.xAxis.title} goes from ${shortNumber(whole.start)} to ${shortNumber(whole.endInclusive)}"
            throw Failure("$file has nothing $asked, since $x; choose another --from or --to.")
        }
        return start..end
    }

    private fun play(server: ReplayServer, console: Console) {
        var known = emptyList<String>()
        while (isLooping || !server.isAtEnd) {
            Thread.sleep(LOOK_MILLIS)
            val clients = server.clientNames
            for (name in clients - known.toSet()) console.warn("$name is connected.")
            for (name in known - clients.toSet()) console.warn("$name has left.")
            known = clients
        }
        // The last values are on their way.
        Thread.sleep(LOOK_MILLIS)
    }

    private companion object {
        const val LOOK_MILLIS = 200L
    }
}
