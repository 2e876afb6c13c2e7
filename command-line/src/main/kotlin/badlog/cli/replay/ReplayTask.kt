package badlog.cli.replay

import badlog.analysis.LogView
import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.LogLoop
import badlog.cli.Task
import badlog.cli.analysis.undefinedLines
import badlog.cli.input.NotALog
import badlog.cli.input.readLog
import badlog.expression.withVirtualTopics
import badlog.recording.Recording
import badlog.replay.ReplayOptions
import badlog.replay.ReplayServer
import badlog.replay.UnavailablePortException
import java.nio.file.Path
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** Serves [file] with [virtualTopics] to dashboards until its end, or, where it [isLooping], until the program is ended. */
internal class ReplayTask(
    private val file: Path,
    private val port: Int,
    private val speed: Double,
    private val isLooping: Boolean,
    private val from: Double?,
    private val to: Double?,
    private val virtualTopics: List<String>,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val recording = try {
            console.progress(file.fileName.toString()).use { readLog(file, it) }
        } catch (e: NotALog) {
            console.err.println(e.message)
            return ExitCode.NOTHING
        } catch (e: Throwable) {
            console.err.println(LogLoop.sentenceOf(e, file))
            return ExitCode.NOTHING
        }
        val with = LogView.of(recording).withVirtualTopics(virtualTopics)
        undefinedLines(with.errors).forEach(console.err::println)
        val view = with.view
        val whole = view.xAxis.range
        val range = if (from == null && to == null || whole == null) null else (from ?: whole.start)..(to ?: whole.endInclusive)
        return try {
            ReplayServer(view, ReplayOptions(port = port, speed = speed, isLooping = isLooping, range = range)).use { play(it, recording, console) }
        } catch (e: UnavailablePortException) {
            console.err.println(e.message)
            ExitCode.NOTHING
        } catch (e: IllegalArgumentException) {
            console.err.println(e.message)
            ExitCode.USAGE
        }
    }

    private fun play(server: ReplayServer, recording: Recording, console: Console): ExitCode {
        server.start()
        val place = JsonObject(mapOf("file" to JsonPrimitive(file.toString()), "port" to JsonPrimitive(server.port)))
        console.out.println(if (isJson) place.toString() else "$file is served on port ${server.port}; Ctrl+C ends it.")
        console.out.flush()
        var known = emptyList<String>()
        while (isLooping || !server.isAtEnd) {
            Thread.sleep(LOOK_MILLIS)
            val clients = server.clientNames
            for (name in clients - known.toSet()) console.err.println("$name is connected.")
            for (name in known - clients.toSet()) console.err.println("$name has left.")
            known = clients
        }
        // The last values are on their way.
        Thread.sleep(LOOK_MILLIS)
        return if (recording.isSalvaged) ExitCode.SALVAGED else ExitCode.WHOLE
    }

    private companion object {
        const val LOOK_MILLIS = 200L
    }
}
