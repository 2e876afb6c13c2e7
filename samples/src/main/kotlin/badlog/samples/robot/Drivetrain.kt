package badlog.samples.robot

import kotlin.math.abs

/**
 * The drivetrain with six wheels, four motors and two gears, and its position on the field. Units are m, s and rad; x runs along the field.
 */
class Drivetrain(var x: Double, var y: Double, var heading: Double) {
    var leftOutput = 0.0
    var rightOutput = 0.0
    var isHighGear = false

    /** Whether the motors follow their outputs; otherwise they brake. */
    var isDriven = true

    /** The sides on which one of two motors has no power. */
    var unplugged: List<Side> = emptyList()

    /** The gearbox that is stuck; null for none. */
    var seized: SeizedGearbox? = null

    /** The resistance of another robot or a wall in the way, in N·s/m. */
    var obstacle = 0.0

    var speed = 0.0
        private set
    var turnRate = 0.0
        private set
    var leftPosition = 0.0
        private set
    var rightPosition = 0.0
        private set

    val leftVelocity get() = speed - turnRate * HALF_TRACK
    val rightVelocity get() = speed + turnRate * HALF_TRACK

    // Motor radians per meter.
    private val gearing get() = (if (isHighGear) HIGH_RATIO else LOW_RATIO) / (WHEEL_DIAMETER / 2)

    fun load(left: List<Load>, right: List<Load>, volts: Double) {
        load(Side.LEFT, left, volts, leftVelocity)
        load(Side.RIGHT, right, volts, rightVelocity)
    }

    private fun load(side: Side, loads: List<Load>, volts: Double, velocity: Double) {
        for ((motor, load) in loads.withIndex()) {
            val turned = if (motor < stuckMotors(side)) 0.0 else velocity
            if (motor < motorsOf(side)) Motor.load(load, outputOf(side), volts, turned * gearing) else load.draw(0.0)
        }
    }

    fun move(volts: Double, seconds: Double) {
        val left = push(Side.LEFT, volts, leftVelocity)
        val right = push(Side.RIGHT, volts, rightVelocity)
        val drag = 25 * speed / (abs(speed) + 0.03) + (5 + obstacle) * speed
        // Wheels that do not steer scrub sideways over the carpet in a turn, less so while they roll.
        val scrub = 55 / (1 + 3 * abs(speed)) * turnRate / (abs(turnRate) + 0.1) + 9 * turnRate
        speed += (left + right - drag) / MASS * seconds
        turnRate += ((right - left) * HALF_TRACK - scrub) / INERTIA * seconds
        heading += turnRate * seconds
        x += speed * cosine(heading) * seconds
        y += speed * sine(heading) * seconds
        leftPosition += shaftVelocity(Side.LEFT) * seconds
        rightPosition += shaftVelocity(Side.RIGHT) * seconds
    }

    /** Returns the speed of a side's gearbox; a stuck one does not turn even while the robot moves. */
    fun shaftVelocity(side: Side): Double = when {
        stuckMotors(side) == MOTORS_PER_SIDE -> 0.0
        side == Side.LEFT -> leftVelocity
        else -> rightVelocity
    }

    private fun stuckMotors(side: Side) = seized?.takeIf { it.side == side }?.motors ?: 0

    /** Hits the robot from the side: it spins and loses speed before anyone can react. */
    fun hit() {
        turnRate += 4.5
        speed *= -0.3
    }

    private fun outputOf(side: Side) = when {
        !isDriven -> 0.0
        side == Side.LEFT -> leftOutput
        else -> rightOutput
    }

    private fun motorsOf(side: Side) = if (side in unplugged) MOTORS_PER_SIDE - 1 else MOTORS_PER_SIDE

    private fun push(side: Side, volts: Double, velocity: Double): Double {
        val stuck = stuckMotors(side)
        val push = ((motorsOf(side) - stuck) * Motor.torque(outputOf(side), volts, velocity * gearing) * gearing).coerceIn(-GRIP, GRIP)
        // Wheels that do not turn are dragged over the carpet.
        return if (stuck == 0) push else push - stuck * DRAG * velocity / (abs(velocity) + 0.05)
    }

    companion object {
        const val WHEEL_DIAMETER = 0.1524
        const val HIGH_RATIO = 8.5
        const val LOW_RATIO = 15.0
        private const val MASS = 62.0
        private const val INERTIA = 6.0
        private const val HALF_TRACK = 0.3
        private const val MOTORS_PER_SIDE = 2

        // The maximum force of the wheels of one side before they slip, in N.
        private const val GRIP = 330.0

        // The drag of one wheel that does not turn, in N.
        private const val DRAG = 70.0
    }
}

/** A gearbox of [side] that is stuck, and the number of [motors] on it. */
class SeizedGearbox(val side: Side, val motors: Int)

/** A side of the drivetrain. */
enum class Side { LEFT, RIGHT }
