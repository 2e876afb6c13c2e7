package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.sign

/** A flywheel under speed control. */
internal class Shooter(val device: Device, private val inertia: Double) {
    private val motor = device.motor

    /** The wanted speed, in 1/min of the wheel. */
    var setpoint = 0.0

    /** The drag at full speed, in N·m at the motor; it grows with the square of the speed. */
    var drag = 0.0
    var dragAtSpeed = 1.0

    /** How far a controller with too much gain makes it swing, as part of the speed; 0 for a healthy one. */
    var swing = 0.0
    private val delayed = DoubleArray(8)
    private var loops = 0

    /** In 1/min of the wheel. */
    val measured: Double get() = device.rpm / motor.gear

    /** Takes the energy of a shot from the wheel. */
    fun shoot() {
        motor.imposeSpeed(motor.speed * 0.88)
    }

    /** Makes something rub, so that at most [share] of [rpm] are reached. */
    fun rub(share: Double, rpm: Double) {
        dragAtSpeed = rpm * share * motor.gear * PI / 30
        drag = motor.torqueAt(dragAtSpeed, 11.6)
    }

    fun step(bus: Double, dt: Double) {
        val part = motor.speed / dragAtSpeed
        motor.turn(bus, inertia, -drag * part * part * sign(motor.speed), 0.02, dt)
    }

    /** What its code does in each loop. */
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

    /** Far too much gain on a late measurement: full correction to one side, then to the other. */
    private fun swinging(error: Double, target: Double): Double {
        val rate = swing * target / DELAY_SECONDS
        val volts = rate * inertia / motor.kind.torquePerAmpere / motor.count * motor.kind.resistance
        return (error * 0.5).coerceIn(-volts, volts)
    }

    private companion object {
        // Of the loops that are held back, of a status frame, and of the loop that uses it.
        const val DELAY_SECONDS = 0.17
    }
}
