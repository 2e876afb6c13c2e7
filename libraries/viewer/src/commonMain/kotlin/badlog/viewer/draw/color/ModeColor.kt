package badlog.viewer.draw.color

import badlog.viewer.draw.mark.RobotMode

/** Returns the color that shades [mode]: amber and blue, which everybody can distinguish, and gray if the log does not have the mode. */
fun modeShade(mode: RobotMode): Shade = when (mode) {
    RobotMode.AUTONOMOUS -> Shade.AUTONOMOUS
    RobotMode.TELEOP -> Shade.TELEOP
    RobotMode.TEST, RobotMode.UTILITY -> Shade.TEST
    RobotMode.ENABLED -> Shade.MUTED
}

/** Returns the opacity of the shading behind a graph: visible at a glance, but weaker than the lines on top of it. */
fun modeOpacity(isDark: Boolean): Double = if (isDark) 0.11 else 0.08
