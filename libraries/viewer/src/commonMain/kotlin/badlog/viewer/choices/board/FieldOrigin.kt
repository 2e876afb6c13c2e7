package badlog.viewer.choices.board

/**
 * The alliance wall from which the poses of a log are measured: the corner at its right end is (0, 0), unless the center of the field is.
 *
 * @property label its name in a menu.
 */
enum class FieldOrigin(val label: String) {
    /** The blue alliance's wall, as in WPILib. */
    BLUE("Blue origin"),

    /** The red alliance's wall. */
    RED("Red origin"),

    /** The wall of the robot's own alliance in each match; the blue one if the log does not have the alliance. */
    AUTO("Auto origin"),

    /** The center of the field as seen from the red alliance's wall: x points to the blue one. */
    CENTER("Center origin"),
    ;

    internal val key: String get() = name.lowercase()

    internal companion object {
        fun of(key: String?): FieldOrigin? = entries.find { it.key == key }
    }
}
