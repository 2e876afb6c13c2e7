package badlog.samples.robot

import kotlin.math.abs

/** An elevator with two motors that follows a profile with feed-forward and a proportional gain. Positions are in m. */
class Elevator(private val gain: Double = GAIN) {
    val profile = MotionProfile(REST, maxVelocity = 1.4, maxAcceleration = 3.5)
    var position = REST
        private set
    var velocity = 0.0
        private set
    var output = 0.0
        private set

    /** Whether one of its motors has no power. */
    var isHalf = false
    private val motors get() = if (isHalf) 1 else MOTORS

    /** Whether its gears are stuck. */
    var isSeized = false

    /** Whether its motors follow their outputs; otherwise they brake. */
    var isDriven = true
    private val drive get() = if (isDriven) output else 0.0

    /** Runs the elevator's code for one loop. Outputs are cut while the robot is not [enabled]. */
    fun control(enabled: Boolean, seconds: Double) {
        if (!enabled) {
            profile.restartAt(position)
            output = 0.0
            return
        }
        profile.advance(seconds)
        val hold = if (profile.position > REST) HOLD else 0.0
        val forward = hold + profile.velocity * PER_VELOCITY + profile.acceleration * PER_ACCELERATION
        output = (forward + gain * (profile.position - position)).coerceIn(-0.6, 1.0)
    }

    fun load(loads: List<Load>, volts: Double) {
        for ((motor, load) in loads.withIndex()) {
            if (motor < motors) Motor.load(load, drive, volts, velocity * GEARING) else load.draw(0.0)
        }
    }

    /** Returns the current that its motor controllers measure, in A; 0 while they only brake. */
    fun windingAmps(volts: Double): Double = if (output == 0.0) 0.0 else abs(motors * Motor.windingAmps(output, volts, velocity * GEARING))

    fun move(volts: Double, seconds: Double) {
        if (isSeized) {
            velocity = 0.0
            return
        }
        val lift = motors * Motor.torque(drive, volts, velocity * GEARING) * GEARING
        val friction = 14 * velocity / (abs(velocity) + 0.02)
        velocity += (lift - friction - WEIGHT) / MOVED_MASS * seconds
        position += velocity * seconds
        if (position < 0.0 || position > TRAVEL) {
            position = position.coerceIn(0.0, TRAVEL)
            velocity = 0.0
        }
    }

    val isAtBottom get() = position < 0.008
    val isAtTop get() = position > TRAVEL - 0.05

    companion object {
        const val GAIN = 3.5
        const val PER_VELOCITY = 0.45
        const val PER_ACCELERATION = 0.022
        const val HOLD = 0.065
        private const val REST = 0.0
        private const val TRAVEL = 1.40
        private const val MOTORS = 2
        private const val GEARING = 279.0
        private const val WEIGHT = 69.0

        // The carriage and the motors' rotors, which count more than the carriage because of the gearbox, in kg.
        private const val MOVED_MASS = 26.0
    }
}
