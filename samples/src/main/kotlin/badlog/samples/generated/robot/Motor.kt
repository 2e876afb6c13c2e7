package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sign
import kotlin.math.sqrt

/**
 * A kind of motor, according to its data sheet at 12 V.
 *
 * @property stallTorque the stall torque in N·m.
 * @property stallCurrent the stall current in A.
 * @property freeRpm the free speed in 1/min.
 * @property inertia the inertia of its rotor, in kg·m².
 */
internal enum class MotorKind(val stallTorque: Double, val stallCurrent: Double, val freeRpm: Double, val inertia: Double) {
    KRAKEN_X60(7.09, 366.0, 6000.0, 5.5e-5),
    FALCON_500(4.69, 257.0, 6380.0, 5.1e-5),
    NEO(2.6, 105.0, 5676.0, 5.5e-5),
    CIM(2.42, 133.0, 5310.0, 7.7e-5),
    ;

    /** The resistance of one winding, in Ω. */
    val resistance: Double = 12 / stallCurrent

    /** The torque constant, in N·m/A. */
    val torquePerAmpere: Double = stallTorque / stallCurrent

    /** The speed constant, in rad/s per V. */
    val speedPerVolt: Double = freeRpm * 2 * PI / 60 / 12
}

/**
 * One or more equal motors on one shaft, with their controller: back-EMF, limits of the stator's and the supply's current, heat.
 *
 * @property part its part of the robot, such as `Elevator` or `Module1/Drive`.
 * @property id its CAN id.
 * @property channel its channel of the power distribution.
 * @property gear the number of turns of the motor per turn of the mechanism.
 * @property statorLimit the limit of each motor's stator current, in A.
 * @property supplyLimit the limit of each motor's supply current, in A.
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
    /** The commanded voltage, in V. */
    var command = 0.0

    /** Whether a command is applied at all; false while disabled, browned out or without CAN. */
    var isEnabled = false

    /** Whether its channel supplies power. */
    var isPowered = true

    /** Whether it is on the CAN bus. */
    var isConnected = true

    /** The share of its torque that a worn or hot motor still has, 0 to 1. */
    var health = 1.0

    /** The speed of the shaft, in rad/s. */
    var speed = 0.0

    /** The position of the shaft, in rad. */
    var position = 0.0

    /** The current in one stator, in A; negative while braking. */
    var current = 0.0
        private set

    /** The battery current of all motors together, in A. */
    var supply = 0.0
        private set

    /** The applied share of the battery's voltage, -1 to 1. */
    var output = 0.0
        private set

    /** The change of [supply] per V of the battery, in A/V. */
    var slope = 0.0
        private set

    /** The temperature in °C. */
    var temperature = 24.0

    private val resistance = kind.resistance
    private val constant = kind.torquePerAmpere

    private fun emf(speed: Double) = speed / kind.speedPerVolt

    /** Returns the maximum torque of all motors together at the shaft, in N·m, at [speed] with [bus] V. */
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
        // Braking has a lower limit, so that the returned current does not raise the battery's voltage too far.
        return if (current * emf < 0) current.coerceIn(-BRAKING * statorLimit, BRAKING * statorLimit) else current
    }

    /**
     * Turns the shaft for [dt] s against a [load] torque and a [friction] torque. Both are in N·m, [inertia] is in kg·m², all at the shaft.
     * Returns the motors' torque at the shaft.
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
            // Back-EMF is stiff at this step, so a motor below its limits is solved implicitly.
            val damping = if (isLimited) 0.0 else strength / resistance / kind.speedPerVolt
            speed = before + dt * (strength * explicit + load) / (inertia + dt * damping)
            current = if (isLimited) explicit else explicit - (speed - before) / kind.speedPerVolt / resistance
            torque = strength * current
            // A motor's torque is its current times a constant, so a weaker motor also draws less.
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

    /** Sets the [speed] that a stop or the ground imposes. */
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
}

private const val BRAKING = 0.45

// The heat capacity of the windings and their surroundings, in J/K.
private const val HEAT_CAPACITY = 420.0
private const val COOLING_SECONDS = 260.0
