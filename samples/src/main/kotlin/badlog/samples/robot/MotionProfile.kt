package badlog.samples.robot

import kotlin.math.abs
import kotlin.math.sign
import kotlin.math.sqrt

/** A setpoint that moves to its goal with limited velocity and acceleration. */
class MotionProfile(position: Double, private val maxVelocity: Double, private val maxAcceleration: Double) {
    var goal = position
    var position = position
        private set
    var velocity = 0.0
        private set
    var acceleration = 0.0
        private set

    fun advance(seconds: Double) {
        val rest = goal - position
        val wanted = minOf(maxVelocity, sqrt(2 * maxAcceleration * abs(rest)), abs(rest) / seconds) * rest.sign
        val change = (wanted - velocity).coerceIn(-maxAcceleration * seconds, maxAcceleration * seconds)
        acceleration = change / seconds
        velocity += change
        position += velocity * seconds
        if (abs(goal - position) < 0.001 * maxVelocity && abs(velocity) < 0.05 * maxVelocity) {
            position = goal
            velocity = 0.0
            acceleration = 0.0
        }
    }

    /** Restarts the profile at the mechanism's position, as after being disabled. */
    fun restartAt(position: Double) {
        this.position = position
        goal = position
        velocity = 0.0
        acceleration = 0.0
    }
}
