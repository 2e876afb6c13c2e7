package badlog.signals.derived

import badlog.core.analysis.Series

/**
 * Returns 1 from where a button is [pressed] until the end of the log, 0 before. It is empty unless the robot is enabled for [HELD_SECONDS] meanwhile,
 * and the button was only pressed for moments before, and often: a switch that stays where it is put is no such button.
 *
 * @param enabledSeconds returns for how long the robot is enabled from a time on.
 */
internal fun stuckButton(pressed: Series, enabledSeconds: (from: Double) -> Double): Series {
    val presses = ArrayList<Double>()
    var since = Double.NaN
    for (i in 0 until pressed.size) {
        val isPressed = pressed.y[i] > 0
        if (isPressed && since.isNaN()) since = pressed.x[i]
        if (!isPressed && !since.isNaN()) {
            presses += pressed.x[i] - since
            since = Double.NaN
        }
    }
    val isButton = presses.size >= MIN_PRESSES && presses.max() <= PRESSED_SECONDS
    if (!isButton || since.isNaN() || enabledSeconds(since) < HELD_SECONDS) return Series(DoubleArray(0), DoubleArray(0))
    return Series(pressed.x, DoubleArray(pressed.size) { if (pressed.x[it] >= since) 1.0 else 0.0 })
}

private const val MIN_PRESSES = 4
private const val PRESSED_SECONDS = 10.0

/** No driver holds a button for that long, in s. */
private const val HELD_SECONDS = 35.0
