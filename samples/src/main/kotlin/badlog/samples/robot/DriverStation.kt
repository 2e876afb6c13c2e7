package badlog.samples.robot

/** The mode that the driver station sets. */
enum class Mode { DISABLED, AUTONOMOUS, TELEOP }

/**
 * The inputs of the robot in one loop.
 *
 * @property throttle the throttle, -1 to 1.
 * @property turn the turning command, -1 to 1, positive to the left.
 * @property obstacle the resistance of something in the way, in N·s/m.
 * @property pieceAfter the time for which the rollers run until a game piece is in them, in s.
 */
class Sticks(
    val throttle: Double,
    val turn: Double,
    val highGear: Boolean,
    val state: Superstructure,
    val obstacle: Double,
    val pieceAfter: Double,
)
