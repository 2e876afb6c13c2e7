package badlog.signals.pose

/** The role of a pose, according to its name. */
enum class PoseRole {
    /** Where the robot was, by its own estimate. */
    DRIVEN,

    /** Where it should have been. */
    PLANNED,

    /** Where a camera saw it, or saw a tag. */
    SEEN,
}

/**
 * A place on the field over time with a heading, by the names of its topics.
 *
 * @property name the part that the topics' names have in common.
 * @property x the topic of the place along the field.
 * @property y the topic of the place across it.
 * @property heading the topic of the heading, or the four of a quaternion: w, x, y, z; empty if there is none.
 * @property meters the length in meters of one unit of [x] and [y].
 * @property radians the angle in radians of one unit of [heading].
 * @property role its role, according to the name.
 * @property list the array that it is an element of; null for none.
 */
data class Pose(
    val name: String,
    val x: String,
    val y: String,
    val heading: List<String>,
    val meters: Double,
    val radians: Double,
    val role: PoseRole,
    val list: String?,
) {
    /** The number of folders it is in. Poses that vendors' libraries log are in more of them than a robot's own. */
    val depth: Int get() = name.count { it == '/' }
}
