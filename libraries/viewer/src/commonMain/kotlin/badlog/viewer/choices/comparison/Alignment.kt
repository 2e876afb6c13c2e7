package badlog.viewer.choices.comparison

/**
 * The moment by which compared logs are aligned; it is at the same x in all of them.
 *
 * @property title the label.
 * @property hint the effect, as a sentence.
 * @property layoutName the name in layout files; must never change.
 */
enum class Alignment(val title: String, val hint: String, val layoutName: String) {
    /** The first x. */
    START("Start", "Every log starts where the open one starts.", "START"),

    /** The first moment at which the robot was enabled; the first x if that is unknown. */
    ENABLED(
        "Enabled",
        "The robot is first enabled at the same time in all logs; a log without that time starts with the open one.",
        "ENABLED",
    ),

    /** The logged x. */
    NONE("No alignment", "Every log keeps its own x.", "AS_LOGGED"),

    /** The place to which a person moved the log. */
    MANUAL("Manual", "You move each log yourself.", "BY_HAND"),
}

/**
 * The moments of a log by which it can be aligned, as x.
 *
 * @property first the smallest x.
 * @property enabled the moment when the robot was first enabled; null if unknown.
 */
class LogMoments(val first: Double, val enabled: Double?)
