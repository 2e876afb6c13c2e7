package badlog.samples.generated.robot

import badlog.samples.generated.fault.Fault
import kotlin.math.PI

/** Plants a fault into a robot by changing the constants of its parts, at the start and during the match. */
internal class Planting(private val robot: Robot, val fault: Fault, private val strength: Double) {
    private val chance = Chance(robot.plan.seed, "fault")

    /** The start of the fault, in s after the start of autonomous. */
    val start = when (fault.id) {
        "code-crash" -> Driver.END - 90 * strength
        "compressor-dead" -> Driver.END - mix(40.0, 120.0)
        else -> chance.between(fault.start.start, fault.start.endInclusive + 1e-9)
    }
    private val isAtOnce = fault.start.endInclusive == 0.0
    private val wheel = robot.drive.wheels[chance.below(robot.drive.wheels.size)]

    /** The faulty part, such as `Elevator`; empty if it is not a part with motors. */
    val part: String = when (fault.id) {
        "tripped-breaker", "can-dropout", "hot-motor", "module-drive-weak", "dragging-brake", "module-offset" -> wheel.drive.motor.part
        "module-steer-lags" -> wheel.steer?.motor?.part.orEmpty()
        "elevator-short", "seized-mechanism", "limit-switch-stuck" -> "Elevator"
        "shooter-slow", "oscillating-controller" -> "Shooter"
        "intake-jam" -> "Intake"
        "broken-chain", "unplugged-encoder", "slipping-encoder", "arm-overshoot" -> "Arm"
        "air-leak", "compressor-dead" -> "Air"
        else -> ""
    }
    private val motor = robot.device(part)?.motor
    private val stretches = when (fault.id) {
        "limit-switch-stuck" -> intermittent(1.0..5.0)
        "unplugged-encoder" -> intermittent(0.4..2.0)
        "can-dropout" -> intermittent(0.5..3.0)
        else -> null
    }
    private val bursts = Episodes.of(chance, start, 160.0, 0.035, 0.03..0.25)
    private var nextEvent = start
    private var isDone = false
    private var wasHit = false

    /** The end of the log because of the fault, in s after the start of autonomous. Infinite if it does not end the log. */
    val end: Double = if (fault.id == "code-crash") start else Double.POSITIVE_INFINITY

    /** Returns whether the link to the Driver Station is lost at [time]. */
    fun isLinkLost(time: Double): Boolean = when (fault.id) {
        "link-loss" -> time in start..start + 20 * strength
        "radio-power-loss" -> time in start + 0.4..start + 0.4 + 30 * strength
        else -> false
    }

    private fun intermittent(lengths: ClosedFloatingPointRange<Double>) =
        if (strength >= 1) Episodes.of(chance, start, 1e6, 1.0, 1e6..1e6) else Episodes.of(chance, start, 160.0, strength, lengths)

    private fun mix(faint: Double, clear: Double) = faint + (clear - faint) * (strength - 0.3) / 0.7

    /** Changes the constants of the robot before the match. */
    fun prepare() {
        when (fault.id) {
            "discharged-battery" -> robot.battery.missingVolts = 1.2 * strength

            "old-battery" -> robot.battery.contact = 0.050 * strength

            "too-much-at-once" -> takeLimits()

            "module-offset" -> wheel.offset = 30 * strength * PI / 180 * if (chance.isIn(0.5)) 1 else -1

            "wheel-slip" -> robot.drive.grip = mix(0.6, 0.35)

            "gyro-drift" -> robot.gyro.drift = strength * PI / 180

            "arm-overshoot" -> robot.arm?.damping = mix(1.0, 0.25)

            "air-leak" -> robot.air?.leak = 4 * strength

            "can-overload" -> {
                robot.bus.overload = mix(0.88, 1.0)
                robot.bus.lost = mix(0.12, 0.45)
            }
        }
    }

    private fun takeLimits() {
        val times = mix(1.5, 3.0)
        for (wheel in robot.drive.wheels) {
            wheel.drive.motor.statorLimit *= times
            wheel.drive.motor.supplyLimit *= times
        }
        robot.driver.push = 1 + 0.35 * strength
    }

    /** Changes the robot at [time], in s after the start of autonomous; [isHit] is true while the robot is hit. */
    fun apply(time: Double, isHit: Boolean) {
        if (time < start && !isAtOnce) {
            before(time)
            return
        }
        when (fault.id) {
            "loose-battery-lead" -> {
                if (isHit) nextEvent = time + 0.2
                robot.battery.contact = if (bursts.holdAt(time) || time < nextEvent) 0.2 * strength else 0.0
            }

            "radio-power-loss" -> pushed(time)

            "tripped-breaker" -> motor?.isPowered = time > start + 100 * strength

            "controller-unplugged" -> robot.driver.isPluggedIn = time > start + mix(4.0, 60.0)

            "garbage-collection" -> collect(time)

            "blocking-call" -> robot.computer.cameraMillis = 60 * strength

            "cpu-overload" -> robot.computer.otherLoad = mix(0.28, 0.62)

            "can-dropout" -> motor?.isConnected = !checkNotNull(stretches).holdAt(time)

            "vision-jumps" -> if (time >= nextEvent) {
                robot.camera?.nextError = 3 * strength
                nextEvent = time + chance.between(2.0, 4.0)
            }

            "gyro-reset" -> once { robot.gyro.jump(strength * chance.between(90.0, 150.0) * PI / 180 * if (chance.isIn(0.5)) 1 else -1) }

            "intake-jam" -> jam(time)

            else -> applyToParts(time)
        }
    }

    private fun applyToParts(time: Double) {
        val elevator = robot.elevator
        val arm = robot.arm
        when (fault.id) {
            "module-steer-lags" -> {
                motor?.health = mix(0.33, 0.04)
                wheel.steerFriction = 0.05
            }

            "module-drive-weak" -> motor?.health = 1 - strength

            "dragging-brake" -> once {
                val force = checkNotNull(motor).torqueAt(0.0, 11.5) * motor.gear / robot.drive.radius
                wheel.drag += 0.45 * strength * force
            }

            "hot-motor" -> motor?.let {
                it.health = 1 - strength
                it.temperature = maxOf(it.temperature, 102.0)
            }

            "elevator-short" -> once { elevator?.run { extraLoad = force() / mix(0.93, 0.55) } }

            "seized-mechanism" -> once { elevator?.run { friction += force() * mix(0.5, 1.2) } }

            "limit-switch-stuck" -> elevator?.isSwitchStuck = checkNotNull(stretches).holdAt(time)

            "shooter-slow" -> once { robot.shooter?.rub(mix(0.9, 0.65), Mechanisms.SHOOTER_RPM) }

            "oscillating-controller" -> robot.shooter?.swing = 0.1 * strength

            "broken-chain" -> arm?.run { chain = if (strength >= 1) 0.0 else peakTorque * mix(0.45, 0.2) }

            "unplugged-encoder" -> arm?.isEncoderConnected = !checkNotNull(stretches).holdAt(time)

            "slipping-encoder" -> arm?.encoderSlip = 0.2 * strength

            "compressor-dead" -> robot.air?.hasCompressor = false
        }
    }

    private fun before(time: Double) {
        when (fault.id) {
            // It warms up.
            "hot-motor" -> motor?.let { if (time > 0) it.temperature = maxOf(it.temperature, 30 + 72 * time / start) }

            // A hard pull.
            "tripped-breaker" -> if (time > start - 6 && !wasHit) {
                wasHit = true
                motor?.run {
                    statorLimit *= 2
                    supplyLimit *= 2
                }
                wheel.drag += 60.0
            }
        }
    }

    private fun once(change: () -> Unit) {
        if (!isDone) change()
        isDone = true
    }

    /** Makes the robot push against something solid at full power, without limits. */
    private fun pushed(time: Double) {
        val isPushing = time < start + 0.45
        robot.drive.isBlocked = isPushing
        if (isPushing == isDone) return
        isDone = isPushing
        robot.battery.contact = if (isPushing) 0.008 else 0.0
        val times = if (isPushing) 2.0 else 1 / 2.0
        for (wheel in robot.drive.wheels) {
            wheel.drive.motor.statorLimit *= times
            wheel.drive.motor.supplyLimit *= times
        }
        // The wheels must not slip against the obstacle.
        robot.drive.grip += if (isPushing) 6.0 else -6.0
        robot.isPushing = isPushing
    }

    private fun collect(time: Double) {
        if (time < nextEvent) return
        robot.computer.pendingPause = mix(75.0, 250.0) * chance.between(0.85, 1.15)
        nextEvent = time + mix(6.0, 2.5) * chance.between(0.85, 1.15)
    }

    private fun jam(time: Double) {
        val intake = robot.intake ?: return
        if (intake.pieceUntil > time && !intake.isJammed) {
            intake.isJammed = true
            intake.pieceUntil = time + 3 * strength
        }
    }
}
