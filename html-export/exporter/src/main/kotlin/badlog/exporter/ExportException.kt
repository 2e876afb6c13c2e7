package badlog.exporter

import java.io.IOException
import java.nio.file.Path

/** Thrown if no page was made. The message is one sentence for the user: what, where, and what to do. */
sealed class ExportException(message: String, cause: Throwable? = null) : IOException(message, cause) {
    /** The [file] to read is missing, is not a file, or cannot be read. */
    class Unreadable internal constructor(val file: Path, message: String, cause: Throwable? = null) :
        ExportException(message, cause)

    /** The [input] is neither a bag, nor CSV, nor another log that this version reads. */
    class NotARecording internal constructor(val input: Path, message: String) : ExportException(message)

    /** The [page] cannot be written: no permission, a full disk, or a folder of that name. */
    class Unwritable(val page: Path, message: String, cause: Throwable? = null) : ExportException(message, cause)
}
