package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sign
import kotlin.math.sin

/**
 * One driven wheel of a swerve drive, or one side of a tank drive.
 *
 * @property x its distance forward of the robot's center, in m; negative behind it.
 * @property y its distance to the left of the robot's center, in m; negative to the right.
 * @property steer the motor that turns it; null on a tank drive.
 */
internal class Wheel(val name: String, val x: Double, val y: Double, val drive: Device, val steer: Device?) {
    /** The difference between the wheel's real angle and its encoder's, in rad. */
    var offset = 0.0

    /** The torque needed to start steering it, at the motor's shaft, in N·m. */
    var steerFriction = 0.012

    /** The force needed to start rolling it, in N. */
    var drag = 10.0

    /** Its angle according to its encoder, in rad. */
    val angle: Double get() = if (steer == null) 0.0 else steer.motor.position / steer.motor.gear

    /** The target of its angle, in rad. */
    var angleTarget = 0.0

    /** The target of its speed, in m/s. */
    var speedTarget = 0.0

    /** Its speed at the rim, in m/s. */
    var speed = 0.0
    internal var isSlipping = false

    /** The angle as last measured, in rad. */
    var measuredAngle = 0.0

    /** Returns the speed that the code measures, in m/s. */
    fun measuredSpeed(radius: Double): Double = drive.rpm * PI / 30 / drive.motor.gear * radius
}

/** The drive: wheels that push the robot with as much force as their grip allows. */
internal class Drive(val isSwerve: Boolean, val wheels: List<Wheel>, private val mass: Double, val radius: Double, val topSpeed: Double) {
    /** The coefficient of friction of its tread. */
    var grip = 1.1

    /** The position and heading on the field, in m and rad. */
    var x = 0.0
    var y = 0.0
    var heading = 0.0

    /** The velocity in the robot's frame, in m/s and rad/s. */
    var vx = 0.0
    var vy = 0.0
    var omega = 0.0

    /** The acceleration along the robot, in m/s². */
    var acceleration = 0.0
        private set

    /** External forces on the robot, along and across the field, in N. */
    var pushX = 0.0
    var pushY = 0.0

    /** Whether something solid blocks it. */
    var isBlocked = false

    /** The inertia of each wheel with its motors, as mass at the rim, in kg. */
    private val rotating = wheels.map { wheel ->
        val motor = wheel.drive.motor
        0.6 * (if (isSwerve) 1 else 3) + motor.count * motor.kind.inertia * (motor.gear / radius) * (motor.gear / radius)
    }
    private val inertia = mass * 0.13
    private var jolt = 0.0

    /** Hits the robot: removes [share] of its speed, and adds [turn] rad/s to its rotation. */
    fun hit(share: Double, turn: Double) {
        jolt += hypot(vx, vy) * share / 0.05
        vx *= 1 - share
        vy *= 1 - share
        omega += turn
    }

    fun step(bus: Double, dt: Double) {
        val normal = mass * G / wheels.size
        var forceX = pushX * cos(heading) + pushY * sin(heading)
        var forceY = -pushX * sin(heading) + pushY * cos(heading)
        var torque = 0.0
        for ((index, wheel) in wheels.withIndex()) {
            val direction = wheel.angle + wheel.offset
            val c = cos(direction)
            val s = sin(direction)
            val groundX = vx - omega * wheel.y
            val groundY = vy + omega * wheel.x
            val along = push(wheel, rotating[index], groundX * c + groundY * s, normal, bus, dt)
            val aside = if (isSwerve) -(SIDE_STIFFNESS * (groundY * c - groundX * s)).coerceIn(-grip * normal, grip * normal) else 0.0
            val fx = along * c - aside * s
            val fy = along * s + aside * c
            forceX += fx
            forceY += fy
            torque += wheel.x * fy - wheel.y * fx
            wheel.steer?.let { it.motor.turn(bus, STEER_INERTIA, 0.0, wheel.steerFriction, dt) }
        }
        if (!isSwerve) {
            // Wheels in line resist turning, and do not slide sideways.
            torque -= (omega * 45).coerceIn(-38.0, 38.0) * grip / 1.1
            vy *= 0.8
        }
        move(forceX, forceY, torque, dt)
    }

    private fun move(forceX: Double, forceY: Double, torque: Double, dt: Double) {
        val ax = forceX / mass
        vx += dt * (ax + omega * vy)
        vy += dt * (forceY / mass - omega * vx)
        omega += dt * torque / inertia
        if (isBlocked) {
            vx = 0.0
            vy = 0.0
            omega *= 0.5
        }
        heading += omega * dt
        x += dt * (vx * cos(heading) - vy * sin(heading))
        y += dt * (vx * sin(heading) + vy * cos(heading))
        acceleration = ax - jolt
        jolt *= 0.6
        wall()
    }

    /** Keeps it on the field. */
    private fun wall() {
        val inside = x in 0.5..FIELD_LENGTH - 0.5 && y in 0.5..FIELD_WIDTH - 0.5
        if (inside) return
        x = x.coerceIn(0.5, FIELD_LENGTH - 0.5)
        y = y.coerceIn(0.5, FIELD_WIDTH - 0.5)
        vx *= 0.8
        vy *= 0.8
    }

    /** Turns a wheel over the ground, which moves at [ground] m/s. Returns the force on the robot along the wheel. */
    private fun push(wheel: Wheel, rotating: Double, ground: Double, normal: Double, bus: Double, dt: Double): Double {
        val motor = wheel.drive.motor
        val ratio = motor.gear / radius
        val share = mass / wheels.size
        if (!wheel.isSlipping) wheel.speed = ground
        motor.imposeSpeed(wheel.speed * ratio)
        val moved = if (wheel.isSlipping) rotating else rotating + share
        val force =
            motor.turn(bus, moved / ratio / ratio, 0.0, 0.0, dt) * ratio * EFFICIENCY -
                wheel.drag * (wheel.speed / 0.05).coerceIn(-1.0, 1.0)
        if (!wheel.isSlipping) {
            val transmitted = force * share / (share + rotating)
            if (abs(transmitted) <= grip * normal) return transmitted
            wheel.isSlipping = true
        }
        val slip = wheel.speed - ground
        val held = SLIDING * grip * normal * (if (abs(slip) > 0.02) sign(slip) else sign(force))
        wheel.speed += dt * (force - held) / rotating
        val after = wheel.speed - ground
        if (abs(after) < 0.02 || sign(after) == -sign(held) || (abs(force) < abs(held) && abs(after) < 0.1)) {
            wheel.isSlipping = false
            wheel.speed = ground
        }
        return held
    }

    /** Makes a swerve drive follow a velocity in the robot's frame, in m/s and rad/s. */
    fun steerTo(forward: Double, left: Double, turn: Double) {
        for (wheel in wheels) {
            val wx = forward - turn * wheel.y
            val wy = left + turn * wheel.x
            var speed = hypot(wx, wy)
            if (speed > 0.03) {
                var error = wrapped(atan2(wy, wx) - wheel.measuredAngle)
                // Turns at most a quarter, and runs backward instead.
                if (abs(error) > PI / 2) {
                    error = wrapped(error + PI)
                    speed = -speed
                }
                wheel.angleTarget = wheel.measuredAngle + error
            }
            wheel.speedTarget = speed
        }
    }

    companion object {
        const val G = 9.81
        const val FIELD_LENGTH = 16.5
        const val FIELD_WIDTH = 8.2
        private const val SIDE_STIFFNESS = 900.0
        private const val EFFICIENCY = 0.92
        private const val SLIDING = 0.85

        // The inertia of a swerve module around its axis, at its motor, in kg·m².
        private const val STEER_INERTIA = 7.0e-5
    }
}

/** Returns [angle], wrapped to the range from -π to π. */
internal fun wrapped(angle: Double): Double = angle - 2 * PI * kotlin.math.round(angle / (2 * PI))
