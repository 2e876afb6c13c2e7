package badlog.viewer.recording

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes

/**
 * What tells whether a file has changed.
 *
 * @property size in bytes.
 * @property modifiedMillis when it was last written, in milliseconds since 1970.
 */
internal data class FileStamp(val size: Long, val modifiedMillis: Long) {
    companion object {
        /** That of [file] now; null when it is not there or cannot be looked at. */
        fun of(file: Path): FileStamp? = try {
            val attributes = Files.readAttributes(file, BasicFileAttributes::class.java)
            FileStamp(attributes.size(), attributes.lastModifiedTime().toMillis())
        } catch (_: IOException) {
            null
        }
    }
}
