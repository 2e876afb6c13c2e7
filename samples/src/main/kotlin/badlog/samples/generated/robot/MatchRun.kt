package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sign
import kotlin.math.sin

/** Receives the events of a running match. */
internal interface MatchObserver {
    /** Called at the end of a loop of the robot's code, at [time] on the log's clock, in s. */
    fun looped(time: Double)

    /** Called when devices have sent their status frames, at [time] on the log's clock, in s. */
    fun framed(time: Double)
}

/** The phases of a match. */
internal enum class Phase(val isEnabled: Boolean) { BEFORE(false), AUTO(true), BETWEEN(false), TELEOP(true), AFTER(false) }

/**
 * A simulation from the start of the robot's code until after the match. Physics runs in steps of 5 ms, status frames are sent every 10 ms,
 * and loops run when the robot's computer has time for them.
 */
internal class MatchRun(val plan: RobotPlan) {
    val robot = Robot(plan)
    val planting = plan.fault?.let { Planting(robot, it, plan.strength) }
    private val chance = Chance(plan.seed, "match")

    /** The start of autonomous on the log's clock, in s. */
    val autoStart = chance.between(12.0, 25.0)
    private val end = autoStart + Driver.END + chance.between(3.0, 8.0)
    private val mechanisms = Mechanisms(robot)
    private val hits = hits()
    private val pushes = pushes()
    private var nextHit = 0
    private val frameEvery = if (plan.hardship == Hardship.SLOW_SENSORS) 10 else 2

    var phase = Phase.BEFORE
        private set

    /** Whether the Driver Station is connected. */
    var isLinked = true
        private set

    /** Whether the robot's code sees it as enabled, which needs a connected Driver Station. */
    val isEnabled: Boolean get() = phase.isEnabled && isLinked
    var isBrownedOut = false
        private set

    /** The current time on the log's clock, in s, in steps of 5 ms. */
    var now = 0.0
        private set
    private var recoveredAt = 0.0
    private var wasEnabled = false

    private class Hit(val time: Double, val share: Double, val turn: Double)

    private fun hits(): List<Hit> {
        val count = if (plan.hardship == Hardship.COLLISIONS) 22 else 3 + chance.below(4)
        val hardest = if (plan.hardship == Hardship.COLLISIONS) 0.9 else 0.6
        return List(count) {
            Hit(chance.between(17.5, Driver.END), chance.between(0.25, hardest), chance.normal(1.2))
        }.sortedBy { it.time }
    }

    private fun pushes(): List<ClosedFloatingPointRange<Double>> {
        val count = if (plan.hardship == Hardship.PUSHED) 7 else 1
        return List(count) { chance.between(20.0, Driver.END - 5).let { it..it + chance.between(1.2, 3.0) } }
    }

    /** Runs the match, and calls [observer] throughout. */
    fun run(observer: MatchObserver) {
        planting?.prepare()
        val until = minOf(end, autoStart + (planting?.end ?: Double.POSITIVE_INFINITY))
        var step = 0
        while (true) {
            val time = step * STEP
            now = time
            if (time >= until) {
                crash(time, observer)
                return
            }
            val match = time - autoStart
            surroundings(match)
            robot.step(match, STEP)
            protect(time)
            if (step % frameEvery == 0) frames(time, observer)
            while (robot.computer.nextLoop < time + STEP) loop(robot.computer.nextLoop, match, observer)
            step++
        }
    }

    private fun surroundings(match: Double) {
        phase = when {
            match < 0 -> Phase.BEFORE
            match < 15 -> Phase.AUTO
            match < 17 -> Phase.BETWEEN
            match < Driver.END -> Phase.TELEOP
            else -> Phase.AFTER
        }
        val isHit = nextHit < hits.size && hits[nextHit].time <= match
        if (isHit) hits[nextHit++].let { robot.drive.hit(it.share, it.turn) }
        val drive = robot.drive
        val isPushed = phase == Phase.TELEOP && pushes.any { match in it }
        // Another robot is in the way and yields slowly.
        val direction = drive.heading + atan2(drive.vy, drive.vx)
        val force = if (isPushed && (abs(drive.vx) > 0.02 || abs(drive.vy) > 0.02)) 330.0 else 0.0
        drive.pushX = -force * cos(direction)
        drive.pushY = -force * sin(direction)
        planting?.apply(match, isHit)
        isLinked = planting?.isLinkLost(match) != true
        for (device in robot.devices) device.motor.isEnabled = isEnabled && !isBrownedOut
    }

    /** The roboRIO switches all outputs off while the voltage is too low. */
    private fun protect(time: Double) {
        val volts = robot.battery.volts
        if (volts < if (robot.isSecondRio) 6.75 else 6.3) {
            isBrownedOut = true
            recoveredAt = Double.POSITIVE_INFINITY
        } else if (isBrownedOut && volts > 7.5) {
            if (recoveredAt == Double.POSITIVE_INFINITY) recoveredAt = time + 0.1
            if (time >= recoveredAt) isBrownedOut = false
        }
    }

    private fun frames(time: Double, observer: MatchObserver) {
        for (device in robot.devices) device.sendFrame(robot.battery.volts, robot.bus.lost)
        for (wheel in robot.drive.wheels) {
            val steer = wheel.steer ?: continue
            wheel.measuredAngle = steer.position * 2 * PI / steer.motor.gear
        }
        robot.arm?.updateSensor()
        observer.framed(time)
    }

    private fun loop(time: Double, match: Double, observer: MatchObserver) {
        val computer = robot.computer
        val isNew = robot.camera?.look(time, robot.drive) == true
        computer.loop(time, isNew, isEnabled)
        robot.bus.loop()
        robot.air?.let {
            it.step(isEnabled, robot.battery.volts, computer.cycleMillis / 1000)
            it.updateSensor()
        }
        robot.measure()
        val seconds = computer.cycleMillis / 1000
        if (phase.isEnabled) {
            robot.driver.look(match, robot.drive, robot.gyro.yaw, seconds)
            if (isEnabled) control(match, seconds)
        }
        robot.odometry.loop(seconds, robot.camera, isNew, phase != Phase.BEFORE || match > -1)
        wasEnabled = isEnabled
        speak(time)
        observer.looped(time)
    }

    private fun control(match: Double, seconds: Double) {
        val drive = robot.drive
        val driver = robot.driver
        // Without a link, or without a controller, sticks read 0.
        if (drive.isSwerve) {
            val c = cos(robot.gyro.yaw)
            val s = sin(robot.gyro.yaw)
            val top = drive.topSpeed
            drive.steerTo((driver.forward * c + driver.left * s) * top, (driver.left * c - driver.forward * s) * top, driver.turn * 6.5)
        } else {
            drive.wheels[0].speedTarget = (driver.forward - driver.turn * 0.7).coerceIn(-1.0, 1.0) * drive.topSpeed
            drive.wheels[1].speedTarget = (driver.forward + driver.turn * 0.7).coerceIn(-1.0, 1.0) * drive.topSpeed
        }
        for (wheel in drive.wheels) {
            val motor = wheel.drive.motor
            val error = wheel.speedTarget - wheel.measuredSpeed(drive.radius)
            val feedforward = wheel.speedTarget / drive.radius * motor.gear / motor.kind.speedPerVolt
            motor.command = feedforward + 0.2 * sign(wheel.speedTarget) + 1.2 * error
            if (robot.isPushing) motor.command = 12.0
            wheel.steer?.motor?.let { it.command = (8 * wrapped(wheel.angleTarget - wheel.measuredAngle)).coerceIn(-8.0, 8.0) }
        }
        mechanisms.plan(match)
        if (!wasEnabled) {
            robot.elevator?.enabled()
            robot.arm?.enabled()
        }
        robot.elevator?.control(seconds)
        robot.arm?.control(seconds)
        robot.shooter?.control()
    }

    private fun speak(time: Double) {
        val console = robot.console
        val computer = robot.computer
        if (computer.userMillis > 20) console.print(time, "overrun") { overrunMessage() }
        if (!robot.driver.isPluggedIn && isEnabled) {
            console.print(time, "joystick") {
                "Warning at edu.wpi.first.wpilibj.DriverStation.reportJoystickUnpluggedWarning(DriverStation.java:1364): " +
                    "Joystick Axis 1 on port 0 not available, check if controller is plugged in"
            }
        }
        for (device in robot.devices) {
            if (!device.isConnected || (robot.bus.hasTimeout && device.motor.id % 3 == (time * 2).toInt() % 3)) {
                console.print(time, "can ${device.motor.id}") { canMessage(device) }
            }
        }
    }

    private fun overrunMessage(): String {
        val computer = robot.computer
        val user = computer.userMillis / 1000
        val vision = computer.visionPart / 1000
        val parts = listOf(
            "Drive.periodic()" to (user - vision) * 0.6,
            "Vision.periodic()" to vision,
            "LiveWindow.updateValues()" to 0.0,
            "robotPeriodic()" to user,
        )
        return "Warning at edu.wpi.first.wpilibj.IterativeRobotBase.printLoopOverrunMessage(IterativeRobotBase.java:436): " +
            "Loop time of 0.02s overrun\n" +
            parts.filter {
                it.second > 0 || it.first.startsWith("Live")
            }.joinToString("\n") { (name, seconds) -> "\t$name: ${"%.6f".format(java.util.Locale.ROOT, seconds)}s" }
    }

    private fun canMessage(device: Device): String {
        val id = device.motor.id
        return if (device.motor.kind == MotorKind.NEO) {
            "Error at frc.robot.Robot.robotPeriodic: [CAN SPARK] IDs: $id, timed out while waiting for Periodic Status 0"
        } else {
            "Error: CAN frame not received/too-stale. Check the CAN bus wiring, CAN bus utilization, and power to the device. " +
                "talon fx $id (\"\") Status Signal Position"
        }
    }

    /** Runs the last loop of the code before it crashes, at [time]. */
    private fun crash(time: Double, observer: MatchObserver) {
        if (planting == null || planting.end.isInfinite()) return
        robot.console.print(time, "exception") {
            "Error at frc.robot.subsystems.Superstructure.periodic(Superstructure.java:148): " +
                "Unhandled exception: java.lang.NullPointerException: " +
                "Cannot invoke \"java.util.Optional.get()\" because \"this.target\" is null"
        }
        robot.console.print(time, "quit") {
            "Warning at edu.wpi.first.wpilibj.RobotBase.runRobot(RobotBase.java:366): " +
                "The robot program quit unexpectedly. This is usually due to a code error."
        }
        observer.looped(time)
    }

    companion object {
        /** The step of the physics, in s. */
        const val STEP = 0.005
    }
}
