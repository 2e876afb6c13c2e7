package badlog.samples.robot

/** The mode that the driver station sets. */
enum class Mode { DISABLED, AUTONOMOUS, TELEOP }

/**
 * What reaches the robot in one loop.
 *
 * @property throttle -1 to 1.
 * @property turn -1 to 1, positive to the left.
 * @property obstacle how hard something holds the robot, in N·s/m.
 * @property pieceAfter how long the rollers run until a game piece is in them, in seconds.
 */
class Sticks(
    val throttle: Double,
    val turn: Double,
    val highGear: Boolean,
    val state: Superstructure,
    val obstacle: Double,
    val pieceAfter: Double,
)
