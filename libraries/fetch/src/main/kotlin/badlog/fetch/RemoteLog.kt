package badlog.fetch

/**
 * A file on a robot, as a look at its folder found it.
 *
 * @property folder where it is, such as `/home/lvuser/logs`.
 * @property name its name there, whatever that holds.
 * @property size in bytes.
 * @property modified when it was written last, in seconds since 1970 by the robot's clock.
 */
internal data class RemoteLog(val folder: String, val name: String, val size: Long, val modified: Long) {
    /** Where it is, as the robot wants it. */
    val path: String get() = "${folder.trimEnd('/')}/$name"
}

/**
 * What a look at a robot's folders found.
 *
 * @property logs what is named like a log.
 * @property refused the names that cannot be those of a file in a folder, such as `../x`.
 * @property folders those that are there.
 */
internal class RemoteListing(val logs: List<RemoteLog>, val refused: List<String>, val folders: List<String>)
