package badlog.exporter

import badlog.files.ReadResult
import java.io.IOException
import java.nio.file.Path

/** Thrown if no page was made. The message is one sentence for the user: the problem, its place, and the next step. */
sealed class ExportException(message: String, cause: Throwable? = null) : IOException(message, cause) {
    /** The [file] to read is missing, is not a file, or cannot be read. */
    class Unreadable internal constructor(val file: Path, message: String, cause: Throwable? = null) :
        ExportException(message, cause)

    /** The file to read is not a bag, CSV, or another log that this version reads; [why] has the reason. */
    class NotARecording private constructor(val why: ReadResult.NotRead) : ExportException(why.sentence) {
        internal constructor(input: Path, refusal: String) : this(ReadResult.NotRead.noLog(input, refusal))
    }

    /** The [page] cannot be written: no permission, a full disk, or a folder of that name. */
    class Unwritable(val page: Path, message: String, cause: Throwable? = null) : ExportException(message, cause)
}
