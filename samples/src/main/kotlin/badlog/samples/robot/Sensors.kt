package badlog.samples.robot

/** The values of the encoders on the mechanisms, including faults of the encoders. */
class Sensors(private val robot: Robot, private val noise: Noise) {
    private val lost = HashSet<Side>()
    var leftPosition = 0.0
        private set
    var leftVelocity = 0.0
        private set
    var rightPosition = 0.0
        private set
    var rightVelocity = 0.0
        private set
    var elevatorPosition = 0.0
        private set
    var elevatorVelocity = 0.0
        private set
    var elevatorAmps = 0.0
        private set

    /** Unplugs the encoder of [side]: its count stays unchanged, without any error. */
    fun loseEncoder(side: Side) {
        lost += side
        if (side == Side.LEFT) leftVelocity = 0.0 else rightVelocity = 0.0
    }

    fun measure(isElevatorSilent: Boolean, seconds: Double) {
        val drivetrain = robot.drivetrain
        if (Side.LEFT !in lost) {
            leftPosition = drivetrain.leftPosition
            leftVelocity = filtered(leftVelocity, drivetrain.shaftVelocity(Side.LEFT), seconds)
        }
        if (Side.RIGHT !in lost) {
            rightPosition = drivetrain.rightPosition
            rightVelocity = filtered(rightVelocity, drivetrain.shaftVelocity(Side.RIGHT), seconds)
        }
        // Without status frames the robot uses the last ones.
        if (isElevatorSilent) return
        elevatorPosition = robot.elevator.position
        elevatorVelocity = filtered(elevatorVelocity, robot.elevator.velocity, seconds)
        elevatorAmps = robot.elevator.windingAmps(robot.battery.volts) * (1 + noise.around(0.02))
    }

    // Motor controllers average their velocity over some 30 ms. At rest an encoder has no noise.
    private fun filtered(last: Double, now: Double, seconds: Double): Double {
        val next = last + (now - last) * (seconds / 0.03).coerceAtMost(1.0)
        return if (StrictMath.abs(now) < 0.002) 0.0 else next + noise.around(0.004)
    }
}

/** A gyro that measures the heading in degrees, counter-clockwise. The heading never wraps. */
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

    /** Restarts the gyro's board, as after a hit. It calibrates while the robot moves, mistakes that for rest, and drifts. */
    fun restart() {
        restarting = 1.3
        driftRate = 1.4
    }
}
