package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sign
import kotlin.math.sqrt

/**
 * A kind of motor, by its data sheet at 12 V.
 *
 * @property stallTorque in N·m.
 * @property stallCurrent in A.
 * @property freeRpm in 1/min.
 * @property inertia of its rotor, in kg·m².
 */
internal enum class MotorKind(val stallTorque: Double, val stallCurrent: Double, val freeRpm: Double, val inertia: Double) {
    KRAKEN_X60(7.09, 366.0, 6000.0, 5.5e-5),
    FALCON_500(4.69, 257.0, 6380.0, 5.1e-5),
    NEO(2.6, 105.0, 5676.0, 5.5e-5),
    CIM(2.42, 133.0, 5310.0, 7.7e-5),
    ;

    /** Of one winding, in Ω. */
    val resistance: Double = 12 / stallCurrent

    /** In N·m/A. */
    val torquePerAmpere: Double = stallTorque / stallCurrent

    /** In rad/s per V. */
    val speedPerVolt: Double = freeRpm * 2 * PI / 60 / 12
}

/**
 * One or more equal motors on one shaft, with their controller: back-EMF, limits of the stator's and the supply's current, heat.
 *
 * @property part the part of the robot it belongs to, as in `Elevator` or `Module1/Drive`.
 * @property id its CAN id.
 * @property channel its channel of the power distribution.
 * @property gear turns of the motor for one of the mechanism.
 * @property statorLimit in A, of each motor.
 * @property supplyLimit in A, of each motor.
 */
internal class Motor(
    val part: String,
    val kind: MotorKind,
    val count: Int,
    val id: Int,
    val channel: Int,
    val gear: Double,
    var statorLimit: Double,
    var supplyLimit: Double,
) {
    /** The commanded voltage. */
    var command = 0.0

    /** Whether a command is applied at all; false while disabled, browned out or without CAN. */
    var isEnabled = false

    /** Whether its channel gives power. */
    var isPowered = true

    /** Whether it is on the CAN bus. */
    var isConnected = true

    /** The part of its torque that a worn or hot motor gives. */
    var health = 1.0

    /** Of the shaft, in rad/s. */
    var speed = 0.0

    /** Of the shaft, in rad. */
    var position = 0.0

    /** Of one stator, in A; negative while it brakes. */
    var current = 0.0
        private set

    /** What all of them take from the battery, in A. */
    var supply = 0.0
        private set

    /** The part of the battery's voltage that is applied, -1 to 1. */
    var output = 0.0
        private set

    /** How much [supply] rises per V of the battery, in A/V. */
    var slope = 0.0
        private set

    /** In °C. */
    var temperature = 24.0

    private val resistance = kind.resistance
    private val constant = kind.torquePerAmpere

    private fun emf(speed: Double) = speed / kind.speedPerVolt

    /** Returns the largest torque at the shaft, of all motors together, at [speed] with [bus] V. */
    fun torqueAt(speed: Double, bus: Double): Double = constant * count * currentAt(bus.coerceAtMost(12.0), bus, speed).coerceAtLeast(0.0)

    private fun currentAt(volts: Double, bus: Double, speed: Double): Double {
        val emf = emf(speed)
        var duty = (volts / bus).coerceIn(-1.0, 1.0)
        val wanted = (duty * bus - emf) / resistance
        if (duty * wanted > supplyLimit) {
            // duty · (duty · bus − emf) / resistance = limit
            val root = sqrt(emf * emf + 4 * bus * resistance * supplyLimit)
            duty = sign(duty) * (sign(duty) * emf + root) / (2 * bus)
        }
        val current = ((duty * bus - emf) / resistance).coerceIn(-statorLimit, statorLimit)
        // Braking is limited more, so that what flows back does not raise the battery's voltage too far.
        return if (current * emf < 0) current.coerceIn(-BRAKING * statorLimit, BRAKING * statorLimit) else current
    }

    /**
     * Turns the shaft for [dt] s against a [load] torque and a [friction] torque, both in N·m at the shaft, with [inertia] in kg·m²
     * at the shaft. Returns the motors' torque at the shaft.
     */
    fun turn(bus: Double, inertia: Double, load: Double, friction: Double, dt: Double): Double {
        val before = speed
        val strength = constant * count * health
        var torque = 0.0
        if (isPowered) {
            // A controller without a command brakes by shorting the motor.
            val volts = if (isEnabled && isConnected) command else 0.0
            val explicit = currentAt(volts, bus, before)
            val isLimited = abs(explicit - (volts.coerceIn(-bus, bus) - emf(before)) / resistance) > 0.5
            // Back-EMF is stiff at this step, so a motor that is not limited is solved implicitly.
            val damping = if (isLimited) 0.0 else strength / resistance / kind.speedPerVolt
            speed = before + dt * (strength * explicit + load) / (inertia + dt * damping)
            current = if (isLimited) explicit else explicit - (speed - before) / kind.speedPerVolt / resistance
            torque = strength * current
            // A motor's torque is its current times a constant: one that gives less also takes less.
            current *= health
            slope = if (isLimited) 0.0 else output * output / resistance * count * health
        } else {
            speed = before + dt * load / inertia
            current = 0.0
            slope = 0.0
        }
        val stop = dt * friction / inertia
        speed = if (abs(speed) <= stop) 0.0 else speed - sign(speed) * stop
        turned(bus, dt, before)
        return torque
    }

    /** Takes over a [speed] that a stop or the ground imposes. */
    fun imposeSpeed(speed: Double) {
        this.speed = speed
    }

    private fun turned(bus: Double, dt: Double, before: Double) {
        position += (speed + before) / 2 * dt
        output = if (!isPowered) 0.0 else ((emf(before) + current * resistance) / bus).coerceIn(-1.0, 1.0)
        supply = output * current * count
        if (!isPowered || !isConnected || !isEnabled) supply = minOf(supply, 0.0)
        val heat = current * current * resistance
        temperature += dt * (heat / HEAT_CAPACITY - (temperature - 24) / COOLING_SECONDS)
    }

    private companion object {
        const val BRAKING = 0.45

        // Of the windings and what surrounds them, in J/K.
        const val HEAT_CAPACITY = 420.0
        const val COOLING_SECONDS = 260.0
    }
}
