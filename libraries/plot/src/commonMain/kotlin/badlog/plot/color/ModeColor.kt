package badlog.plot.color

import badlog.plot.timeline.RobotMode

/** The color that shades [mode]: amber and blue, which everybody tells apart, and gray where the log does not say which it was. */
public fun modeShade(mode: RobotMode): Shade = when (mode) {
    RobotMode.AUTONOMOUS -> Shade.AUTONOMOUS
    RobotMode.TELEOP -> Shade.TELEOP
    RobotMode.ENABLED -> Shade.MUTED
}

/** How much of its color the shading behind a graph has: seen at a glance, and quieter than the lines upon it. */
public fun modeOpacity(isDark: Boolean): Double = if (isDark) 0.11 else 0.08
