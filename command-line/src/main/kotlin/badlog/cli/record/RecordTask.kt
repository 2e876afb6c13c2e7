package badlog.cli.record

import badlog.cli.command.ExitCode
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.jsonOf
import badlog.cli.text.sizeText
import badlog.files.terminal.StatusLine
import badlog.networktables.record.RecordListener
import badlog.networktables.record.RecordOptions
import badlog.networktables.record.RecordProgress
import badlog.networktables.record.RecordedFile
import badlog.networktables.record.RecordedServer
import badlog.networktables.record.Recorder
import badlog.networktables.record.ServerAddress
import badlog.networktables.record.connectedText
import badlog.networktables.record.lostText
import kotlinx.serialization.Serializable
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * Records [servers] until the program is ended, or this thread is interrupted.
 *
 * @param places the searched addresses of the robot, as text for people.
 */
internal class RecordTask(
    private val servers: List<RecordedServer>,
    private val places: String,
    private val options: RecordOptions,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val outcomes = Outcomes("record", console, isJson)
        RecordTalk(console, outcomes, isJson).use { talk ->
            talk.report("Looking for the robot at $places; Ctrl+C ends it.")
            val recorder = Recorder(servers, options, talk)
            val isDone = CountDownLatch(1)
            val end = endingOf(Thread.currentThread(), isDone)
            Runtime.getRuntime().addShutdownHook(end)
            try {
                recorder.use { watch(it, talk) }
                recorder.failure?.let { outcomes.failed(options.folder, it) }
                if (!talk.hasFiles && recorder.failure == null) outcomes.failed(options.folder, talk.nothing(places))
            } finally {
                talk.close()
                isDone.countDown()
                unlessExiting { Runtime.getRuntime().removeShutdownHook(end) }
            }
        }
        return outcomes.end()
    }

    private fun watch(recorder: Recorder, talk: RecordTalk) = try {
        recorder.start()
        do talk.show(recorder.progress) while (recorder.await(SHOW_MILLIS))
    } catch (_: InterruptedException) {
        // The person has recorded enough.
    }

    /** Returns a hook that lets [thread] close the log and say where it is, before the program ends. */
    private fun endingOf(thread: Thread, isDone: CountDownLatch) = Thread {
        thread.interrupt()
        isDone.await(CLOSING_SECONDS, TimeUnit.SECONDS)
    }

    private fun unlessExiting(action: () -> Unit) = try {
        action()
    } catch (_: IllegalStateException) {
        // The hook has ended this.
    }
}

/** Reports events, and shows the progress. Called on two threads. */
private class RecordTalk(private val console: Console, private val outcomes: Outcomes, private val isJson: Boolean) :
    RecordListener,
    AutoCloseable {
    private var line: StatusLine? = console.status()
    private var values = 0L
    private var nanos = System.nanoTime()
    private var isConnected = false

    /** Whether there is a log. */
    @get:Synchronized
    var hasFiles = false
        private set

    /** Returns the reason why there is no log, as a sentence. */
    @Synchronized
    fun nothing(places: String): String = if (isConnected) {
        "Nothing was recorded, because the robot was not enabled; leave out --each-enable to record the whole session."
    } else {
        "No NetworkTables server answered at $places, so nothing was recorded; check the network, or name the robot's address."
    }

    @Synchronized
    fun show(progress: RecordProgress) {
        val now = System.nanoTime()
        val rate = ((progress.values - values) * NANOS / maxOf(now - nanos, 1)).toLong()
        values = progress.values
        nanos = now
        val state = if (progress.isConnected) "" else "not connected; "
        val size = "${counted(progress.values, "value")} of ${counted(progress.topics.toLong(), "topic")}, ${sizeText(progress.bytes)}"
        line?.show("$state$size, ${grouped(rate)}/s")
    }

    @Synchronized
    override fun connected(name: String, address: ServerAddress) {
        isConnected = true
        report(connectedText(name, address))
    }

    @Synchronized
    override fun disconnected(name: String, reason: String) = report(lostText(name, reason))

    @Synchronized
    override fun noted(message: String) = report(message)

    @Synchronized
    override fun finished(file: RecordedFile) {
        line?.close()
        hasFiles = true
        val parts = listOfNotNull(
            "${counted(file.values, "value")} of ${counted(file.topics.toLong(), "topic")}, ${sizeText(file.bytes)}",
            "the connection was lost ${counted(file.gaps.toLong(), "time")}".takeIf { file.gaps > 0 },
            "${counted(file.dropped, "value")} missing, because the disk was too slow".takeIf { file.dropped > 0 },
            "${counted(file.late, "value")} with earlier times than before".takeIf { file.late > 0 },
        )
        val json = jsonOf(RecordJson(file.values, file.topics, file.bytes, file.dropped, file.late, file.gaps))
        outcomes.done(file.path, Outcome(file.dropped > 0, "${file.path}: ${parts.joinToString("; ")}", json))
    }

    @Synchronized
    fun report(message: String) {
        line?.close()
        if (!isJson) console.warn(message)
    }

    @Synchronized
    override fun close() {
        line?.close()
        line = null
    }
}

@Serializable
private class RecordJson(
    private val values: Long,
    private val topics: Int,
    private val bytes: Long,
    private val dropped: Long,
    private val late: Long,
    private val gaps: Int,
)

private const val SHOW_MILLIS = 500L
private const val CLOSING_SECONDS = 10L

private const val NANOS = 1e9
