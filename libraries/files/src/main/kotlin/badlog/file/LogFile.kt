package badlog.file

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A log as a look at its folder finds it, without reading it. As long as this is the same, so is what it holds.
 *
 * @property path where it is; the first of its [parts][partsOfLog].
 * @property size in bytes, of all parts.
 * @property modified when it was written last, in milliseconds since 1970.
 */
public data class LogFile(public val path: Path, public val size: Long, public val modified: Long) {
    /** Its name without the folders. */
    public val name: String get() = path.fileName.toString()

    /** The same log with the file [other], which is a part of it. */
    internal fun with(other: LogFile) = copy(size = size + other.size, modified = maxOf(modified, other.modified))

    public companion object {
        /**
         * The file at [path] as it is now.
         *
         * @throws IOException when it is not there or cannot be looked at.
         */
        public fun of(path: Path): LogFile = partsOfLog(path).map(::single).reduce(LogFile::with)

        private fun single(path: Path) = LogFile(path, Files.size(path), Files.getLastModifiedTime(path).toMillis())
    }
}
