package badlog.file

import java.io.IOException
import java.nio.file.Path

/**
 * A file or a folder cannot be read. The message is one sentence for the person who asked: what, where, and what to do.
 *
 * @property file what was to be read.
 */
public class UnreadableFileException(public val file: Path, override val message: String, cause: Throwable? = null) :
    IOException(message, cause)
