package badlog.report.hook

import badlog.analysis.periodicTimes
import badlog.analysis.resampled
import badlog.bag.BagHeader
import badlog.bag.BagTopic
import badlog.bag.BagValue
import badlog.bag.RecordingWriter
import badlog.bag.headerText
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Runs a program of the user's for recordings; `docs/hooks.md` has what it gets and what it may return. Safe for several threads.
 *
 * What runs is [command] alone, word by word and without a shell. Nothing that stands in a log becomes part of it. It is to be
 * given by the person who starts the program, never by a file that came with the logs.
 *
 * @property command the program and its arguments; in an argument `{header}` becomes the path of the header's file.
 * @property timeLimit how long the program may take for one recording before it and all it started are killed.
 * @property name what to call it.
 * @property folder where it runs; null for where this program runs.
 */
public class HookRunner(
    public val command: List<String>,
    public val timeLimit: Duration = USUAL_TIME_LIMIT,
    public val name: String = command.joinToString(" "),
    public val folder: Path? = null,
) {
    init {
        require(command.isNotEmpty()) { "The command of the hook is empty." }
        require(timeLimit.isPositive()) { "The time limit of a hook is above 0, not $timeLimit." }
    }

    /**
     * Runs the program for [recording], read with its samples. One without rows, as a WPILOG, is given in rows of 20 ms, each with
     * the last values until then.
     *
     * @throws HookException when it cannot be started, takes too long, fails, or returns something else than it has to.
     * @throws InterruptedException when the thread was interrupted; the program is then killed.
     */
    public fun run(recording: Recording): HookResult {
        val header = try {
            Files.createTempFile("badlog-header-", ".json")
        } catch (e: IOException) {
            throw HookException("No temporary file can be written for the hook: ${e.message}.", "", e)
        }
        try {
            val rows = inRows(recording)
            Files.writeString(header, headerOf(rows))
            return Run(start(header), rows).use { it.result() }
        } catch (e: HookException) {
            throw e
        } catch (e: IOException) {
            throw HookException("The program “${command[0]}” cannot be run: ${e.message}.", "", e)
        } finally {
            Files.deleteIfExists(header)
        }
    }

    private fun start(header: Path): Process = try {
        ProcessBuilder(command.map { it.replace("{header}", header.toString()) }).apply {
            environment()["BADLOG_HEADER"] = header.toString()
            directory(folder?.toFile())
        }.start()
    } catch (e: IOException) {
        throw HookException("The program “${command[0]}” cannot be started; is it installed, and in the PATH?", "", e)
    }

    private inner class Run(private val process: Process, private val recording: Recording) : AutoCloseable {
        private val output = PipeReader(process.inputStream, MOST_OUTPUT, keepsEnd = false)
        private val errors = PipeReader(process.errorStream, MOST_ERRORS, keepsEnd = true)
        private val started = HashSet<ProcessHandle>()
        private val end = System.nanoTime() + timeLimit.inWholeNanoseconds
        private val leftMillis get() = (end - System.nanoTime()) / 1_000_000
        private val input = Thread(::feed, "badlog-hook-input").apply {
            isDaemon = true
            start()
        }

        fun result(): HookResult {
            while (!process.waitFor(minOf(POLL, maxOf(1, leftMillis)), TimeUnit.MILLISECONDS)) {
                // What a program started can no longer be found when it has ended itself.
                process.descendants().forEach(started::add)
                if (output.isTooLong) fail("The hook printed more than ${MOST_OUTPUT shr 20} MB.")
                if (leftMillis <= 0) fail("The hook took longer than $timeLimit and was stopped.")
            }
            if (!output.join(leftMillis) || !errors.join(leftMillis)) {
                fail("The hook ended, but something it started took longer than $timeLimit and was stopped.")
            }
            if (output.isTooLong) fail("The hook printed more than ${MOST_OUTPUT shr 20} MB.")
            val code = process.exitValue()
            if (code != 0) fail("The hook ended with the exit code $code${lastError()}.")
            return try {
                HookOutput(errors.text()).read(output.text())
            } catch (e: IllegalArgumentException) {
                throw HookException(e.message.orEmpty(), errors.text(), e)
            }
        }

        private fun lastError(): String {
            val line = errors.text().lines().lastOrNull { it.isNotBlank() && it.trim() != R_ENDED } ?: return ""
            return " and said: ${line.trim().trimEnd('.').take(MOST_QUOTED)}"
        }

        private fun fail(message: String): Nothing {
            close()
            errors.join(POLL)
            throw HookException(message, errors.text())
        }

        private fun feed() {
            try {
                process.outputStream.use { out ->
                    RecordingWriter(recording, RecordingFormat.CSV).write { bytes, size -> out.write(bytes, 0, size) }
                }
            } catch (_: IOException) {
                // A program need not read all, or any, of its input.
            }
        }

        override fun close() {
            process.descendants().forEach(started::add)
            started += process.toHandle()
            // Not the process itself, which would wait for its streams: for those who still read and write them.
            started.forEach(ProcessHandle::destroyForcibly)
            input.join(POLL)
        }
    }

    public companion object {
        /** How long a program may take where nobody says otherwise. */
        public val USUAL_TIME_LIMIT: Duration = 30.seconds

        private const val POLL = 50L
        private const val MOST_OUTPUT = 64 shl 20
        private const val MOST_ERRORS = 64 shl 10
        private const val MOST_QUOTED = 300

        /** What R says last of all, whatever went wrong. */
        private const val R_ENDED = "Execution halted"

        /** The line of a bag, or one that says as much of another file. */
        private fun headerOf(recording: Recording): String = recording.headerLine ?: headerText(
            BagHeader(
                recording.topics.map { BagTopic(it.name, it.unit, it.attributes) },
                recording.values.map { BagValue(it) },
            ),
        )

        /** A loop of the robot. */
        private const val PERIOD = 0.02

        private fun inRows(recording: Recording): Recording =
            if (recording.topics.any { it.times != null }) resampled(recording, periodicTimes(recording, PERIOD)) else recording
    }
}
