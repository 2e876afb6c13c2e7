package badlog.season.lake

import java.io.Serializable

/**
 * A log as found in a local or remote folder. As long as its source is equal, its content is unchanged.
 *
 * @property path its identity in a lake: the full path of its file on this machine, or its address on another file system.
 * @property file the file's name without folders.
 * @property name its name in the lake, with slashes, usually its path below the folder of logs; if another log has that name in the lake, a
 *   number is added.
 * @property size the size of all its files, in bytes.
 * @property modified the time of its last change, in ms since 1970.
 */
data class LogSource(val path: String, val file: String, val name: String, val size: Long, val modified: Long) : Serializable

private const val serialVersionUID = 1L
