package badlog.samples.match

/** What the driver station tells the robot to be. */
enum class Mode { DISABLED, AUTONOMOUS, TELEOP }
