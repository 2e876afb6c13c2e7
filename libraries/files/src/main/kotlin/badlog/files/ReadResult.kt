package badlog.files

import badlog.core.recording.LogFormat
import badlog.core.recording.Recording
import java.nio.file.Path
import java.util.concurrent.CancellationException

/** The result of reading a log: see [readLog]. */
public sealed interface ReadResult {
    /**
     * Returns the recording.
     *
     * @throws NotReadException if there is none. The exception of a bug is thrown unchanged.
     */
    public fun orThrow(): Recording

    /**
     * The log was read.
     *
     * @property recording its content.
     */
    public class Read(public val recording: Recording) : ReadResult {
        override fun orThrow(): Recording = recording
    }

    /**
     * The log was not read.
     *
     * @property file the file that was read.
     * @property cause the kind of reason.
     * @property message the reason and the remedy, in one sentence, which does not always name [file].
     */
    public class NotRead private constructor(
        public val file: Path,
        public val cause: Cause,
        public val message: String,
        private val failure: Throwable?,
    ) : ReadResult {
        /** Whether the log stays unreadable until the file changes. */
        public val isLasting: Boolean get() = cause == Cause.NO_LOG

        /** The [message], with the path of [file] in it. */
        public val sentence: String get() = naming(file, message)

        // A report of a bug needs its stack trace.
        override fun orThrow(): Recording = throw failure?.takeIf { cause == Cause.BUG } ?: NotReadException(this)

        public companion object {
            /** Returns the result for [failure], which ended the work on the log in [file]. */
            public fun of(file: Path, failure: Throwable): NotRead = when (failure) {
                is NotReadException -> failure.why
                is TooLargeFileException -> NotRead(file, Cause.TOO_LARGE, failure.message, failure)
                is UnreadableFileException -> NotRead(file, Cause.UNREADABLE, failure.message, failure)
                is UnwritableFileException -> NotRead(file, Cause.NO_ROOM, failure.message, failure)
                is OutOfMemoryError -> NotRead(file, Cause.TOO_LARGE, tooLargeSentence("$file"), failure)
                else -> NotRead(file, Cause.BUG, "${bugIn(failure)}, with the file if you may share it.", failure)
            }

            /** Returns the result for [file], which is not a log because of [refusal], a sentence. */
            public fun noLog(file: Path, refusal: String): NotRead = NotRead(file, Cause.NO_LOG, refusal, failure = null)
        }
    }

    /** The kind of reason why a log was not read. */
    public enum class Cause {
        /** The file is something other than a log. */
        NO_LOG,

        /** The file is missing, may not be read, or its disk fails. */
        UNREADABLE,

        /** A file needed for reading cannot be written: usually the disk of the folder for temporary files is full. */
        NO_ROOM,

        /** The file does not fit into memory. */
        TOO_LARGE,

        /** badlog has a bug. */
        BUG,
    }
}

/**
 * Thrown if a log was not read, by callers that cannot go on without it.
 *
 * @property why the reason.
 */
public class NotReadException(public val why: ReadResult.NotRead) : UnreadableFileException(why.file, why.sentence)

/**
 * Reads [file] as [readRecording] does; any failure becomes a result.
 *
 * @throws InterruptedException if the thread was interrupted.
 */
public fun readLog(
    file: Path,
    formats: List<LogFormat>,
    options: ReadOptions = ReadOptions(),
    progress: (doneBytes: Long, totalBytes: Long) -> Unit = { _, _ -> },
): ReadResult = orNotRead(file, { it }) {
    val recording = readRecording(file, formats, options, progress)
    recording.refusal?.let { ReadResult.NotRead.noLog(file, it) } ?: ReadResult.Read(recording)
}

/**
 * Returns the result of [work] on the log in [file]; if that fails, the result of [otherwise]. Even lack of memory or a bug is a result: a
 * failure of one log must not affect others. An interruption of the thread and a cancellation of the work are passed on.
 */
public inline fun <R> orNotRead(file: Path, otherwise: (ReadResult.NotRead) -> R, work: () -> R): R = try {
    work()
} catch (e: InterruptedException) {
    throw e
} catch (e: CancellationException) {
    throw e
} catch (e: Exception) {
    otherwise(ReadResult.NotRead.of(file, e))
} catch (e: OutOfMemoryError) {
    otherwise(ReadResult.NotRead.of(file, e))
} catch (e: StackOverflowError) {
    otherwise(ReadResult.NotRead.of(file, e))
}

/** Returns [message], a sentence about [file], preceded by the file's path unless it already contains the path. */
public fun naming(file: Path, message: String): String = if ("$file" in message) message else "$file: $message"

/** Returns a sentence that says that [what] needs too much memory, and suggests a remedy. */
public fun tooLargeSentence(what: String): String {
    val megabytes = Runtime.getRuntime().maxMemory() shr 20
    return "$what does not fit into the $megabytes MB of memory that this program may use; set JAVA_TOOL_OPTIONS, to -Xmx8g for example."
}

/** Returns a sentence that reports [failure], a bug in badlog, without naming a file. */
public fun bugSentence(failure: Throwable): String = "${bugIn(failure)}."

private fun bugIn(failure: Throwable) = "This is a bug in badlog (${failure.toString().lineSequence().first()}); report it"
