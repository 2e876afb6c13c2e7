package badlog.rules.number

/**
 * A way to reduce a topic's samples in a log to one number, for comparison with other logs.
 *
 * @property words the condition, as part of a sentence; empty if there is none.
 */
enum class Measure(val words: String) {
    /** The mean over teleop. */
    TELEOP("in teleop"),

    /** The mean over the time in which the robot was enabled and its drivetrain had an output. */
    DRIVING("while driving"),

    /** The mean over the time in which the robot was enabled. */
    ENABLED("while enabled"),

    /** The smallest sample while the robot was enabled. */
    LOWEST("at its lowest"),

    /** The largest sample while the robot was enabled. */
    HIGHEST("at its highest"),

    /** The value that samples exceed for one twentieth of the time in which the robot was enabled. */
    PERCENTILE95("in its 95th percentile"),

    /** The slope of the battery's voltage against the total current, in milliohms. */
    RESISTANCE(""),
}
