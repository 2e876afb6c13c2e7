package badlog.report.hook

import badlog.core.bag.RecordingWriter
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import java.io.IOException
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import kotlin.time.Duration

/**
 * A hook that runs as [process], and receives the rows of [recording]. It ends with [close], which may be called repeatedly and from any
 * thread.
 *
 * @param nanos returns the time in ns since an arbitrary moment, for measuring [timeLimit].
 */
internal class HookRun(
    private val process: Process,
    private val recording: Recording,
    private val timeLimit: Duration,
    private val nanos: () -> Long,
) : AutoCloseable {
    private val output = PipeReader(process.inputStream, MAX_OUTPUT, keepsEnd = false)
    private val errors = PipeReader(process.errorStream, MAX_ERRORS, keepsEnd = true)
    private val started = ConcurrentHashMap.newKeySet<ProcessHandle>()
    private val end = nanos() + timeLimit.inWholeNanoseconds
    private val leftMillis get() = (end - nanos()) / 1_000_000
    private val input = Thread(::feed, "badlog-hook-input").apply {
        isDaemon = true
        start()
    }

    /** Returns the program's result. Throws a [HookException] if there is none. */
    fun result(): HookResult {
        while (!process.waitFor(minOf(POLL, maxOf(1, leftMillis)), TimeUnit.MILLISECONDS)) {
            // The children of a program cannot be found once it has ended.
            process.descendants().forEach(started::add)
            if (output.isTooLong) fail("The hook printed more than ${MAX_OUTPUT shr 20} MB.")
            if (leftMillis <= 0) fail("The hook took longer than $timeLimit and was stopped.")
        }
        if (!output.join(leftMillis) || !errors.join(leftMillis)) {
            fail("The hook ended, but something it started took longer than $timeLimit and was stopped.")
        }
        if (output.isTooLong) fail("The hook printed more than ${MAX_OUTPUT shr 20} MB.")
        val code = process.exitValue()
        if (code != 0) throw HookException("The hook ended with exit code $code${lastError("; its last error")}.")
        return try {
            HookOutput.read(output.text())
        } catch (e: IllegalArgumentException) {
            fail(e.message.orEmpty(), e)
        }
    }

    /** Returns the program's last error message after [intro]; empty if there is none. */
    private fun lastError(intro: String): String {
        val line = errors.text().lines().lastOrNull { it.isNotBlank() && it.trim() != R_ENDED } ?: return ""
        return "$intro: ${line.trim().trimEnd('.').take(MAX_QUOTED)}"
    }

    private fun fail(message: String, cause: Throwable? = null): Nothing {
        close()
        errors.join(POLL)
        val said = lastError(" Its last error").let { if (it.isEmpty()) "" else "$it." }
        throw HookException(message + said, cause)
    }

    private fun feed() {
        try {
            process.outputStream.use { out ->
                RecordingWriter(recording, RecordingFormat.CSV).write { bytes, size -> out.write(bytes, 0, size) }
            }
        } catch (_: IOException) {
            // A program need not read its input.
        }
    }

    @Synchronized
    override fun close() {
        process.descendants().forEach(started::add)
        started += process.toHandle()
        // Not the process itself, which would wait for its streams. These wait for the threads that still read and write them.
        started.forEach(ProcessHandle::destroyForcibly)
        input.join(POLL)
    }
}

private const val POLL = 50L
private const val MAX_OUTPUT = 64 shl 20
private const val MAX_ERRORS = 64 shl 10
private const val MAX_QUOTED = 300

/** The last line that R prints after any error. */
private const val R_ENDED = "Execution halted"
