package badlog.samples.robot

import kotlin.math.abs

/** A camera that looks for the target above the goal. */
class Camera(private val noise: Noise) {
    private var blind = 0.0

    /** The angle to the target in degrees, positive to the right; null if no target is seen. */
    var targetX: Double? = null
        private set
    var latency = 24.0
        private set

    fun look(drivetrain: Drivetrain, seconds: Double, stallSeconds: Double) {
        val dx = TARGET_X - drivetrain.x
        val dy = TARGET_Y - drivetrain.y
        val bearing = degrees(wrapped(direction(dx, dy) - drivetrain.heading))
        blind -= seconds
        // A robot drives past, or a light dazzles the camera.
        if (noise.unit() < 0.004) blind = 0.08 + noise.unit() * 0.4
        val isSharp = abs(drivetrain.turnRate) < 2.2 && blind <= 0
        val isSeen = abs(bearing) < HALF_VIEW && dx * dx + dy * dy < 42 && isSharp
        targetX = if (isSeen) -bearing + noise.around(0.12) else null
        val wanted = 22 + (if (isSeen) 5 else 0) + noise.around(1.6) + stallSeconds * 900
        latency += (wanted - latency) * 0.5
    }

    companion object {
        const val TARGET_X = 0.3
        const val TARGET_Y = 3.0
        private const val HALF_VIEW = 29.8
    }
}
