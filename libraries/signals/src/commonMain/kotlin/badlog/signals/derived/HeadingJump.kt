package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.round

/**
 * Returns the size of the jump of [heading] at each sample, in degrees; 0 if there is none. A jump is more than a robot turns from sample
 * to sample, given how fast it turned just before and just after. A full turn is not a jump, since angles are counted from 0 to 360° or
 * from -180 to 180°. A jump to a multiple of 90° is not one either: a driver or the program has set it. A single sample beside two others
 * that agree was misread. While the robot turns fast, a late sample looks like a jump.
 *
 * @param degrees the factor from its numbers to degrees.
 */
fun headingJump(heading: Series, degrees: Double): Series {
    val jumps = DoubleArray(heading.size)
    for (i in 2 until heading.size - 1) {
        val seconds = heading.x[i] - heading.x[i - 1]
        if (seconds <= 0 || seconds > LONGEST_STEP) continue
        val step = turned(heading, i, degrees)
        if (abs(step) < MIN_DEGREES) continue
        val usual = (rate(heading, i - 1, degrees) + rate(heading, i + 1, degrees)) / 2
        val jump = abs(step - usual * seconds)
        val isReal =
            jump > MIN_DEGREES && abs(step) / seconds > FASTEST && !isSet(heading.y[i] * degrees) && !isMisread(heading, i, degrees) &&
                !isMisread(heading, i - 1, degrees)
        if (isReal && !turnsFast(heading, i - 1, degrees) && !turnsFast(heading, i + TURN_SAMPLES, degrees, i + 1)) jumps[i] = jump
    }
    return Series(heading.x, jumps)
}

private fun isSet(degrees: Double) = abs(degrees - QUARTER_TURN * round(degrees / QUARTER_TURN)) < SET_WITHIN

/** Returns whether the samples before and after [at] agree; only used where [at] itself is far from one of them. */
private fun isMisread(heading: Series, at: Int, degrees: Double): Boolean {
    val step = (heading.y[at + 1] - heading.y[at - 1]) * degrees
    return abs(step - FULL_TURN * round(step / FULL_TURN)) < MIN_DEGREES
}

/** Returns whether it turned fast over the samples before [at], those from [from] on, without jumps. */
private fun turnsFast(heading: Series, at: Int, degrees: Double, from: Int = 1): Boolean {
    val last = at.coerceAtMost(heading.size - 1)
    val first = maxOf(last - TURN_SAMPLES + 1, from)
    if (first > last) return false
    val seconds = heading.x[last] - heading.x[first - 1]
    return seconds > 0 && abs((first..last).sumOf { slowlyTurned(heading, it, degrees) }) / seconds > FAST
}

private fun slowlyTurned(heading: Series, at: Int, degrees: Double): Double =
    turned(heading, at, degrees).let { if (abs(it) > FASTEST * (heading.x[at] - heading.x[at - 1])) 0.0 else it }

private fun turned(heading: Series, at: Int, degrees: Double): Double {
    val step = (heading.y[at] - heading.y[at - 1]) * degrees
    return if (step.isFinite()) step - FULL_TURN * round(step / FULL_TURN) else 0.0
}

private fun rate(heading: Series, at: Int, degrees: Double): Double {
    val seconds = heading.x[at] - heading.x[at - 1]
    return if (seconds > 0) (turned(heading, at, degrees) / seconds).coerceIn(-FASTEST, FASTEST) else 0.0
}

private const val FULL_TURN = 360.0
private const val QUARTER_TURN = 90.0

/** A heading that was just set has moved on by that much, in degrees. */
private const val SET_WITHIN = 1.0

/** The number of samples over which a robot turns fast. */
private const val TURN_SAMPLES = 5

/** In °/s. */
private const val FAST = 200.0
private const val MIN_DEGREES = 12.0

/** No robot turns faster, in °/s. */
private const val FASTEST = 900.0

/** After a longer gap, in s, it is unknown how the robot turned. */
private const val LONGEST_STEP = 0.12

/** Degrees in a radian. */
const val DEGREES_PER_RADIAN: Double = 180 / PI
