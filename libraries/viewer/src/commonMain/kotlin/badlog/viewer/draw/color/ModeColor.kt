package badlog.viewer.draw.color

import badlog.viewer.draw.mark.RobotMode

/**
 * Returns the shade of [mode]. It is amber for autonomous and blue for teleop, which everybody can distinguish, and gray if the log does
 * not name the mode.
 */
fun modeShade(mode: RobotMode): Shade = when (mode) {
    RobotMode.AUTONOMOUS -> Shade.AUTONOMOUS
    RobotMode.TELEOP -> Shade.TELEOP
    RobotMode.TEST, RobotMode.UTILITY -> Shade.TEST
    RobotMode.ENABLED -> Shade.MUTED
}

/** Returns the opacity of the shade behind a graph. It is visible at a glance, but weaker than the lines on top of it. */
fun modeOpacity(isDark: Boolean): Double = if (isDark) 0.11 else 0.08
