package badlog.samples.robot

/** Measures the heading, in degrees, counter-clockwise; it never wraps. */
class Gyro(private val noise: Noise) {
    private var drift = 0.0
    private var driftRate = 0.004
    private var restarting = 0.0
    var angle = 0.0
        private set

    fun measure(drivetrain: Drivetrain, seconds: Double) {
        restarting -= seconds
        drift += driftRate * seconds
        angle = if (restarting > 0) Double.NaN else degrees(drivetrain.heading) + drift + noise.around(0.015)
    }

    /** A hit makes its board restart. It then calibrates while the robot moves, takes that for rest, and drifts. */
    fun restart() {
        restarting = 1.3
        driftRate = 1.4
    }
}
