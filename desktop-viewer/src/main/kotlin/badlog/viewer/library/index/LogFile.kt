package badlog.viewer.library.index

import java.nio.file.Path

/**
 * A file as a look at its folder finds it, without reading it. As long as this is the same, so is what the file holds.
 *
 * @property path where it is; absolute.
 * @property size in bytes.
 * @property modified when it was written last, in milliseconds since 1970.
 */
internal data class LogFile(val path: Path, val size: Long, val modified: Long) {
    /** Its name without the folders. */
    val name: String get() = path.fileName.toString()
}
