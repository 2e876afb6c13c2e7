package badlog.files

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A log as found in its folder, before it is read. As long as this stays equal, the content is unchanged.
 *
 * @property path its path; the first of its [parts][partsOfLog].
 * @property size its size in bytes, of all parts.
 * @property modified when it was last written, in milliseconds since 1970.
 */
public data class LogFile(public val path: Path, public val size: Long, public val modified: Long) {
    /** Its name without the folders. */
    public val name: String get() = path.fileName.toString()

    /** Returns this log together with [other], another file of the same log. */
    internal fun with(other: LogFile) = copy(size = size + other.size, modified = maxOf(modified, other.modified))

    public companion object {
        /**
         * Returns the file at [path] in its current state.
         *
         * @throws IOException if it does not exist or cannot be accessed.
         */
        public fun of(path: Path): LogFile = partsOfLog(path).map(::single).reduce(LogFile::with)

        private fun single(path: Path) = LogFile(path, Files.size(path), Files.getLastModifiedTime(path).toMillis())
    }
}
