package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.max
import kotlin.math.round
import kotlin.math.sin

/** The kinds of tasks for the robot. */
internal enum class Action { TRAVEL, INTAKE, SCORE }

/** A part of the driver's plan. It ends [until] s after the start of autonomous. */
internal class Errand(val until: Double, val x: Double, val y: Double, val heading: Double, val action: Action, val share: Double)

/** The driver and the autonomous routine. Both fetch game pieces at one end of the field and score them at the other. */
internal class Driver(seed: Long, private val plan: RobotPlan) {
    private val chance = Chance(seed, "driver")
    private val haste = if (plan.hardship == Hardship.LONG_SPRINT) 1.0 else chance.between(0.72, 0.92)
    val errands = plannedErrands()
    private var at = 0

    /** The sticks, -1 to 1, in steps of 1/128: along and across the field, or forward for a tank drive; and turning. */
    var forward = 0.0
        private set
    var left = 0.0
        private set
    var turn = 0.0
        private set

    /** Whether the controller is plugged in. */
    var isPluggedIn = true

    /** The driver's use of power as a multiple of the usual one. */
    var push = 1.0
    private var headingCorrection = 0.0

    val errand: Errand get() = errands[at]

    /** The start of the current errand. */
    val errandStart: Double get() = if (at == 0) 0.0 else errands[at - 1].until

    private fun plannedErrands(): List<Errand> = buildList {
        val isSprinting = plan.hardship == Hardship.LONG_SPRINT
        var time = 0.0
        while (time < END) {
            val isAuto = time < 15
            val far = if (isAuto) 6.5 else 14.2
            val y = chance.between(1.5, Drive.FIELD_WIDTH - 1.5)
            val travel = if (isAuto) chance.between(2.2, 3.0) else chance.between(3.2, 4.8) * if (isSprinting) 0.85 else 1.0
            val pause = if (isSprinting) 0.5 else 1.0
            val speed = haste * chance.between(0.85, 1.0)
            time += travel
            add(Errand(time, 2.3, y, PI, Action.TRAVEL, speed))
            time += chance.between(1.0, 1.8) * pause
            add(Errand(time, 2.0, y, PI, Action.INTAKE, 0.35))
            val goal = chance.between(2.5, 5.5)
            time += travel
            add(Errand(time, far, goal, 0.0, Action.TRAVEL, speed))
            time += chance.between(1.8, 2.8) * pause
            add(Errand(time, far + 0.3, goal, 0.0, Action.SCORE, 0.3))
        }
    }

    /** Looks at the robot and moves the sticks at [time] of the match. */
    fun look(time: Double, drive: Drive, measuredHeading: Double, dt: Double) {
        while (at < errands.lastIndex && errands[at].until <= time) at++
        if (!isPluggedIn) {
            forward = 0.0
            left = 0.0
            turn = 0.0
            return
        }
        val goal = errand
        val dx = goal.x - drive.x
        val dy = goal.y - drive.y
        val distance = hypot(dx, dy)
        val braking = if (plan.hardship == Hardship.HARD_BRAKING) 2.6 else 1.3
        val share = minOf(goal.share * push, braking * distance / drive.topSpeed, 1.0)
        // Drivers hold a stick still only roughly.
        val shake = chance.normal(0.012)
        val shake2 = chance.normal(0.012)
        if (drive.isSwerve) holonomic(dx, dy, share, goal, drive, measuredHeading, dt) else arcade(dx, dy, distance, share, goal, drive, dt)
        forward = stick(forward + if (share > 0.05) shake else 0.0)
        left = stick(left + if (share > 0.05) shake2 else 0.0)
        turn = stick(turn)
    }

    private fun holonomic(dx: Double, dy: Double, share: Double, goal: Errand, drive: Drive, measuredHeading: Double, dt: Double) {
        // A driver notices within seconds that the robot drifts to one side, and corrects it.
        headingCorrection += wrapped(wrapped(measuredHeading - drive.heading) - headingCorrection) * dt / 3
        val direction = atan2(dy, dx) + headingCorrection
        forward = slewed(forward, share * cos(direction), dt)
        left = slewed(left, share * sin(direction), dt)
        turn = slewed(turn, (wrapped(goal.heading - drive.heading) * 0.45).coerceIn(-0.6, 0.6), dt)
    }

    private fun arcade(dx: Double, dy: Double, distance: Double, share: Double, goal: Errand, drive: Drive, dt: Double) {
        val direction = if (distance > 0.35) atan2(dy, dx) else goal.heading
        var error = wrapped(direction - drive.heading)
        val isBackward = distance > 0.35 && abs(error) > PI / 2
        if (isBackward) error = wrapped(error + PI)
        val ahead = max(0.0, cos(error * 1.4)) * share * if (isBackward) -1 else 1
        forward = slewed(forward, if (distance > 0.15) ahead else 0.0, dt)
        left = 0.0
        turn = slewed(turn, (error * 0.5).coerceIn(-0.5, 0.5), dt)
    }

    private fun slewed(from: Double, to: Double, dt: Double): Double {
        val rate = if (plan.hardship == Hardship.HARD_BRAKING) 12.0 else 3.5
        return from + (to - from).coerceIn(-rate * dt, rate * dt)
    }

    private fun stick(value: Double) = round(value.coerceIn(-1.0, 1.0) * 128) / 128

    companion object {
        /** The end of the match after autonomous, a pause and teleop, in s. */
        const val END = 15.0 + 2.0 + 135.0
    }
}
