package badlog.fetch

/**
 * A file on a robot, as listed in its folder.
 *
 * @property folder its folder, such as `/home/lvuser/logs`.
 * @property name its name there, which may contain anything.
 * @property size its size in bytes.
 * @property modified when it was last written, in seconds since 1970 by the robot's clock.
 */
internal data class RemoteLog(val folder: String, val name: String, val size: Long, val modified: Long) {
    /** Its path on the robot. */
    val path: String get() = "${folder.trimEnd('/')}/$name"
}

/**
 * The listing of a robot's folders.
 *
 * @property logs the files with names of logs.
 * @property refused the names that are not valid in a folder, such as `../x`.
 * @property folders the existing folders.
 */
internal class RemoteListing(val logs: List<RemoteLog>, val refused: List<String>, val folders: List<String>)
