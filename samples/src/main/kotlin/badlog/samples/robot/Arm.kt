package badlog.samples.robot

import kotlin.math.abs

/** The arm on the elevator's carriage. Angles are in degrees above the horizontal. */
class Arm {
    private val profile = MotionProfile(STOWED_ANGLE, maxVelocity = 170.0, maxAcceleration = 700.0)
    private var rate = 0.0
    private var isPowered = false
    var angle = STOWED_ANGLE
        private set

    val setpoint get() = profile.position

    fun control(goal: Double, enabled: Boolean, seconds: Double) {
        isPowered = enabled
        if (enabled) profile.goal = goal else profile.restartAt(angle)
        profile.advance(seconds)
    }

    fun load(load: Load) {
        val lift = 2.2 * cosine(angle * StrictMath.PI / 180) + 0.004 * abs(profile.acceleration) + 0.03 * abs(rate)
        load.draw(if (isPowered) abs(lift) else 0.0)
    }

    /** Moves the arm like a damped spring around the setpoint. It overshoots slightly, as with slack in the chain. */
    fun move(seconds: Double) {
        rate += (260 * (setpoint - angle) - 19 * rate) * seconds
        angle += rate * seconds
    }

    companion object {
        const val STOWED_ANGLE = 95.0
    }
}
