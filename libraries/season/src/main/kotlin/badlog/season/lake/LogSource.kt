package badlog.season.lake

import java.io.Serializable

/**
 * A log as a look at its folder finds it, wherever that folder is. As long as this is the same, so is what the log holds.
 *
 * @property path what a lake knows it by: the full path of its file on this machine, or its address on another file system.
 * @property file the file's name without folders.
 * @property name what the lake calls it, with slashes, mostly its path below the folder of logs; where another log has that name in the
 *   lake, it gets a number.
 * @property size in bytes, of all its files.
 * @property modified when it was written last, in milliseconds since 1970.
 */
data class LogSource(val path: String, val file: String, val name: String, val size: Long, val modified: Long) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}
