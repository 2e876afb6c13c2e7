package badlog.files

import badlog.core.recording.LogFormat
import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import java.nio.file.Path
import java.util.concurrent.CancellationException

/** What became of reading a log: see [readLog]. */
public sealed interface ReadResult {
    /**
     * It was read.
     *
     * @property recording its content.
     */
    public class Read(public val recording: Recording) : ReadResult

    /**
     * There is nothing to show of it.
     *
     * @property cause why.
     * @property message why, and what to do, as a sentence.
     */
    public class NotRead(public val cause: Cause, public val message: String) : ReadResult {
        /** Whether that stays so until the file changes. */
        public val isLasting: Boolean get() = cause == Cause.NO_LOG
    }

    /** Why a log was not read. */
    public enum class Cause {
        /** The file is something other than a log. */
        NO_LOG,

        /** The file is missing, may not be read, or its disk fails. */
        UNREADABLE,

        /** It does not fit into memory. */
        TOO_LARGE,

        /** badlog failed. */
        BUG,
    }
}

/**
 * Reads [file] as [readRecording] does; whatever prevents it is a result.
 *
 * @throws InterruptedException if the thread was interrupted.
 */
public fun readLog(
    file: Path,
    formats: List<LogFormat>,
    keepSamples: Boolean = true,
    sinks: NumberSinks = NumberSinks.RECORDING,
    cores: Int = Runtime.getRuntime().availableProcessors(),
    name: String = file.fileName.toString(),
    progress: (doneBytes: Long, totalBytes: Long) -> Unit = { _, _ -> },
): ReadResult = orNotRead({ it }) {
    val recording = readRecording(file, formats, keepSamples, untilLastLineEnd = false, sinks, cores, name, progress)
    val refusal = recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }
    if (refusal == null) ReadResult.Read(recording) else ReadResult.NotRead(ReadResult.Cause.NO_LOG, refusal.message)
}

/**
 * Returns the result of [work] on one log; if that fails, for want of memory or because of a bug, the result of [otherwise]: a failure of
 * one log must not affect others. Passes on that the thread was interrupted, or the work cancelled.
 */
public inline fun <R> orNotRead(otherwise: (ReadResult.NotRead) -> R, work: () -> R): R = try {
    work()
} catch (e: InterruptedException) {
    throw e
} catch (e: CancellationException) {
    throw e
} catch (e: TooLargeFileException) {
    otherwise(ReadResult.NotRead(ReadResult.Cause.TOO_LARGE, e.message))
} catch (e: UnreadableFileException) {
    otherwise(ReadResult.NotRead(ReadResult.Cause.UNREADABLE, e.message))
} catch (_: OutOfMemoryError) {
    otherwise(ReadResult.NotRead(ReadResult.Cause.TOO_LARGE, "It $TOO_LARGE"))
} catch (e: Exception) {
    otherwise(failed(e))
} catch (e: StackOverflowError) {
    otherwise(failed(e))
}

@PublishedApi
internal fun failed(e: Throwable): ReadResult.NotRead =
    ReadResult.NotRead(ReadResult.Cause.BUG, "This is a bug in badlog ($e); report it, with the file if you may share it.")

/** What is wrong with a log that needs too much memory, and what helps, as the end of a sentence. */
@PublishedApi
internal val TOO_LARGE: String
    get() {
        val megabytes = Runtime.getRuntime().maxMemory() shr 20
        return "does not fit into the $megabytes MB of memory that this program may use; set JAVA_TOOL_OPTIONS, to -Xmx8g for example."
    }
