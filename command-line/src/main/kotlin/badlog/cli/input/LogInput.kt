package badlog.cli.input

import java.nio.file.Path

/**
 * A file to read.
 *
 * @property file where it is.
 * @property folder the folder in which it was found, or null when it was named itself. Nobody is sure that what was found is
 *   a log.
 */
internal class LogInput(val file: Path, val folder: Path?) {
    /** Whether nobody named it. */
    val isFound: Boolean get() = folder != null

    /** Where it is, seen from the folder in which it was found; its name, when it was named itself. */
    val relativePath: Path get() = folder?.relativize(file) ?: file.fileName
}
