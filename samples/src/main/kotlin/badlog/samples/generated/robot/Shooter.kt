package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.sign

/** A flywheel under speed control. */
internal class Shooter(val device: Device, private val inertia: Double) {
    private val motor = device.motor

    /** The setpoint of the wheel's speed, in 1/min. */
    var setpoint = 0.0

    /** The drag at full speed, in N·m at the motor; it grows with the square of the speed. */
    var drag = 0.0
    var dragAtSpeed = 1.0

    /** The oscillation caused by a controller with too much gain, as a share of the speed. 0 for a healthy one. */
    var swing = 0.0
    private val delayed = DoubleArray(8)
    private var loops = 0

    /** The measured speed of the wheel, in 1/min. */
    val measured: Double get() = device.rpm / motor.gear

    /** Removes the energy of a shot from the wheel. */
    fun shoot() {
        motor.imposeSpeed(motor.speed * 0.88)
    }

    /** Adds friction, so that at most [share] of [rpm] is reached. */
    fun rub(share: Double, rpm: Double) {
        dragAtSpeed = rpm * share * motor.gear * PI / 30
        drag = motor.torqueAt(dragAtSpeed, 11.6)
    }

    fun step(bus: Double, dt: Double) {
        val part = motor.speed / dragAtSpeed
        motor.turn(bus, inertia, -drag * part * part * sign(motor.speed), 0.02, dt)
    }

    /** Runs the shooter's code in a loop. */
    fun control() {
        val target = setpoint * motor.gear * PI / 30
        val now = device.rpm * PI / 30
        delayed[loops++ % delayed.size] = now
        val volts = target / motor.kind.speedPerVolt
        motor.command = when {
            setpoint <= 0 -> 0.0
            swing > 0 && kotlin.math.abs(target - now) < 0.25 * target -> volts + swinging(target - delayed[loops % delayed.size], target)
            else -> volts * 1.01 + 0.06 * (target - now)
        }.coerceIn(-12.0, 12.0)
    }

    /** Returns the correction of a controller with far too much gain on a late measurement: full to one side, then to the other. */
    private fun swinging(error: Double, target: Double): Double {
        val rate = swing * target / DELAY_SECONDS
        val volts = rate * inertia / motor.kind.torquePerAmpere / motor.count * motor.kind.resistance
        return (error * 0.5).coerceIn(-volts, volts)
    }
}

// The total delay of the loops held back, a status frame, and the loop that uses it.
private const val DELAY_SECONDS = 0.17
