package badlog.samples.generated.robot

import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min
import kotlin.math.sqrt

/** A setpoint that moves to its goal with limited speed and acceleration. */
internal class Profile(private val topSpeed: Double, private val topAcceleration: Double) {
    var goal = 0.0
    var position = 0.0
    var speed = 0.0

    fun reset(at: Double) {
        position = at
        speed = 0.0
    }

    fun step(dt: Double) {
        val rest = goal - position
        val wanted = min(topSpeed, sqrt(2 * topAcceleration * abs(rest))) * if (rest < 0) -1 else 1
        speed += (wanted - speed).coerceIn(-topAcceleration * dt, topAcceleration * dt)
        if (abs(rest) < 0.004 && abs(speed) < topAcceleration * dt * 2) {
            position = goal
            speed = 0.0
        } else {
            position += speed * dt
        }
    }
}

/** An elevator with a carriage on a rope, a switch at the bottom and a profiled controller. */
internal class Elevator(val device: Device, private val mass: Double, private val drum: Double, val height: Double) {
    private val motor = device.motor

    /** The height above the bottom, in m. */
    var position = 0.0
        private set
    val profile = Profile(1.1, 3.5)

    /** The force needed to start moving it, in N. */
    var friction = 25.0

    /** The extra weight above half of its height, in N. */
    var extraLoad = 0.0

    /** Whether the switch is stuck, as if pressed. */
    var isSwitchStuck = false
    val isSwitchPressed: Boolean get() = isSwitchStuck || position < 0.008

    /** The height as measured by the motor, in m. */
    val measured: Double get() = device.position * 2 * Math.PI / motor.gear * drum - zero
    private var zero = 0.0
    private var wasPressed = true

    /** Returns the force of its motors at their limits, in N. */
    fun force(): Double = motor.torqueAt(0.0, 11.5) * motor.gear / drum

    fun step(bus: Double, dt: Double) {
        val ratio = motor.gear / drum
        val inertia = mass / ratio / ratio + motor.kind.inertia * motor.count
        val load = (mass * Drive.G + if (position > height / 2) extraLoad else 0.0) / ratio
        // A gearbox holds part of the weight.
        val before = motor.speed
        motor.turn(bus, inertia, -load * if (before > 0) 1.0 else 0.9, friction / ratio, dt)
        position += motor.speed / ratio * dt
        if ((position < 0 && motor.speed < 0) || (position > height && motor.speed > 0)) {
            motor.imposeSpeed(0.0)
            motor.position -= (position - position.coerceIn(0.0, height)) * ratio
            position = position.coerceIn(0.0, height)
        }
    }

    /** Runs the part of the elevator's code that handles becoming enabled. */
    fun enabled() = profile.reset(measured)

    /** Runs the elevator's code in a loop of [dt] s. */
    fun control(dt: Double) {
        if (isSwitchPressed && !wasPressed) zero = device.position * 2 * Math.PI / motor.gear * drum
        wasPressed = isSwitchPressed
        profile.step(dt)
        val ratio = motor.gear / drum
        val hold = mass * Drive.G / ratio / motor.kind.torquePerAmpere / motor.count * motor.kind.resistance
        val error = profile.position - measured
        val volts = hold + profile.speed * ratio / motor.kind.speedPerVolt + 40 * error
        // It must not go down while the switch is pressed.
        motor.command = if (isSwitchPressed) max(volts, 0.0) else volts.coerceIn(-11.0, 11.0)
        if (isSwitchPressed && profile.goal < 0.01 && !isSwitchStuck) motor.command = 0.0
    }
}
