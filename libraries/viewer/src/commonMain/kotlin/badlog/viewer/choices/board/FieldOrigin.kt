package badlog.viewer.choices.board

/**
 * The origin from which a log's poses are measured. It is the corner at the right end of an alliance's wall, or the center of the field.
 *
 * @property label the name in a menu.
 */
enum class FieldOrigin(val label: String) {
    /** The blue alliance's wall, as in WPILib. */
    BLUE("Blue origin"),

    /** The red alliance's wall. */
    RED("Red origin"),

    /** The wall of the robot's own alliance in each match; the blue wall if the log does not name the alliance. */
    AUTO("Auto origin"),

    /** The center of the field as seen from the red alliance's wall: x points towards the blue wall. */
    CENTER("Center origin"),
    ;

    internal val key: String get() = name.lowercase()

    internal companion object {
        fun of(key: String?): FieldOrigin? = entries.find { it.key == key }
    }
}
