package badlog.file

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A file as a look at its folder finds it, without reading it. As long as this is the same, so is what the file holds.
 *
 * @property path where it is.
 * @property size in bytes.
 * @property modified when it was written last, in milliseconds since 1970.
 */
public data class LogFile(public val path: Path, public val size: Long, public val modified: Long) {
    /** Its name without the folders. */
    public val name: String get() = path.fileName.toString()

    public companion object {
        /**
         * The file at [path] as it is now.
         *
         * @throws IOException when it is not there or cannot be looked at.
         */
        public fun of(path: Path): LogFile = LogFile(path, Files.size(path), Files.getLastModifiedTime(path).toMillis())
    }
}
