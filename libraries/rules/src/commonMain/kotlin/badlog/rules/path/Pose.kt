package badlog.rules.path

/** What a pose is, as its name says. */
public enum class PoseRole {
    /** Where the robot was, as it believed itself. */
    DRIVEN,

    /** Where it was to be. */
    PLANNED,

    /** Where a camera saw it, or saw a tag. */
    SEEN,
}

/**
 * A place on the field over time with a heading, by the names of the topics that tell it.
 *
 * @property name what the topics have in common.
 * @property x the topic of the place along the field.
 * @property y the topic of the place across it.
 * @property heading the topic of the heading, or the four of a quaternion: w, x, y, z; empty where none tells it.
 * @property meters how many meters one of [x] and [y] is.
 * @property radians how many radians one of [heading] is.
 * @property role what the name says that it is.
 * @property list the array that it is an element of; null for none.
 */
public data class Pose(
    public val name: String,
    public val x: String,
    public val y: String,
    public val heading: List<String>,
    public val meters: Double,
    public val radians: Double,
    public val role: PoseRole,
    public val list: String?,
) {
    /** In how many folders it stands: what a vendor's library logs besides a robot's own pose stands in many. */
    public val depth: Int get() = name.count { it == '/' }
}
