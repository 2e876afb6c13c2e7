package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.round
import kotlin.math.sign

/** An arm on a chain, with an absolute encoder on its shaft. */
internal class Arm(val device: Device, private val inertia: Double, private val weightTorque: Double, private val chance: Chance) {
    private val motor = device.motor

    /** The angle above horizontal, in rad. */
    var angle = LOWEST
        private set
    private var speed = 0.0
    val profile = Profile(2.6, 9.0)

    /** The maximum torque that the chain carries, at the arm, in N·m. */
    var chain = 1e6
    private var isLoose = false
    private var parted = -LOWEST * motor.gear

    /** Whether its encoder is connected. */
    var isEncoderConnected = true

    /** The share of each upward movement that its encoder misses. */
    var encoderSlip = 0.0
    private var slipped = 0.0

    /** The damping of a faulty controller with an integral part. 0 for the healthy controller, which has a profile and no integral part. */
    var damping = 0.0
    private var integral = 0.0

    /** The encoder's angle, in rad. */
    var measured = LOWEST
        private set

    /** The current setpoint of the angle, in rad. */
    val setpoint: Double get() = if (damping > 0) profile.goal else profile.position

    /** The usual peak torque at the arm, in N·m. */
    val peakTorque: Double get() = weightTorque + inertia * 9

    fun step(bus: Double, dt: Double) {
        val gear = motor.gear
        val rotor = motor.kind.inertia * motor.count * gear * gear
        val weight = -weightTorque * cos(angle)
        val before = speed
        if (!isLoose) {
            motor.imposeSpeed(speed * gear)
            val torque = motor.turn(bus, (inertia + rotor) / gear / gear, weight / gear, 1.2 / gear, dt) * gear
            speed = motor.speed / gear
            // The torque in the chain is the part of the motor's torque that reaches the arm.
            val carried = torque - rotor * (speed - before) / dt
            if (abs(carried) > chain) isLoose = true
        } else {
            motor.turn(bus, rotor / gear / gear * 3, -sign(motor.speed - speed * gear) * chain / gear * 0.6, 0.3 / gear, dt)
            val carried = chain * 0.6 * sign(motor.speed / gear - speed)
            speed += dt * (weight + carried - 4.0 * speed) / inertia
            if (chain > 1 && abs(motor.speed / gear - speed) < 0.15) isLoose = false
        }
        angle += speed * dt
        if ((angle < LOWEST && speed < 0) || (angle > HIGHEST && speed > 0)) {
            angle = angle.coerceIn(LOWEST, HIGHEST)
            speed = 0.0
            if (!isLoose) motor.imposeSpeed(0.0)
        }
        // A chain holds motor and arm together, even at a stop; only with a loose chain do they move apart.
        if (isLoose) parted = motor.position - angle * gear else motor.position = parted + angle * gear
        if (speed > 0) slipped += encoderSlip * speed * dt
    }

    fun updateSensor() {
        val noise = chance.normal(0.0004)
        measured = if (isEncoderConnected) round((angle - slipped + noise) / STEP) * STEP else DEAD
    }

    /** Runs the part of the arm's code that handles becoming enabled. */
    fun enabled() {
        profile.reset(measured)
        integral = 0.0
    }

    /** Runs the arm's code in a loop of [dt] s. */
    fun control(dt: Double) {
        profile.step(dt)
        val error = setpoint - measured
        val perRadian = motor.gear / motor.kind.speedPerVolt
        val hold = weightTorque * cos(measured) / motor.gear / motor.kind.torquePerAmpere / motor.count * motor.kind.resistance
        val volts = if (damping > 0) {
            // Proportional for 3.5 rad/s per rad, and too much integral.
            val rate = 3.5
            integral = (integral + error * dt).coerceIn(-3.0, 3.0)
            hold + perRadian * (rate * error + rate * rate / (4 * damping * damping) * integral)
        } else {
            hold + perRadian * (profile.speed + 7 * error)
        }
        motor.command = volts.coerceIn(-10.0, 10.0)
    }
}

private const val LOWEST = -0.35
private const val HIGHEST = 1.75

// The encoder's resolution: a turn in 4,096 steps.
private const val STEP = 2 * PI / 4096

// The angle read without an encoder: the code subtracts its offset from 0.
private const val DEAD = -0.9
