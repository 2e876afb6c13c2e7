package badlog.samples.match

import badlog.samples.robot.Camera
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Noise
import badlog.samples.robot.Sticks
import badlog.samples.robot.cosine
import badlog.samples.robot.direction
import badlog.samples.robot.sine
import badlog.samples.robot.wrapped
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A driver's style.
 *
 * @property fastest the highest throttle across the field, 0 to 1.
 * @property ramp the maximum change of the throttle per second.
 */
class DrivingStyle(val fastest: Double = 0.88, val ramp: Double = 2.0)

/** Follows orders as people do: with a reaction time, and slightly differently each time. */
class Driver(seed: Long, private val orders: List<Order>, private val style: DrivingStyle = DrivingStyle()) {
    private val noise = Noise(seed)
    private var throttle = 0.0
    private var turn = 0.0
    private var highGear = false
    private var tremor = 0.0
    private var current: Order? = null
    private var pieceAfter = 1.0
    private var loopSeconds = 0.0
    private var hasArrived = false

    /** Whether the last call of [drive] began a new order. */
    var hasNewOrder = false
        private set

    val order: Order? get() = current

    fun drive(time: Double, seconds: Double, enabled: Boolean, drivetrain: Drivetrain): Sticks {
        val order = orders.lastOrNull { it.at <= time } ?: orders.first()
        hasNewOrder = order !== current
        if (hasNewOrder) {
            current = order
            hasArrived = false
            pieceAfter = 0.7 + noise.unit() * 0.8
        }
        loopSeconds = seconds
        setTargets(order.task, drivetrain)
        if (!enabled) {
            throttle = 0.0
            turn = 0.0
        }
        tremor += (noise.around(0.05) - tremor) * 0.08
        val isMoving = throttle != 0.0 || turn != 0.0
        return Sticks(
            throttle = if (isMoving) (throttle + tremor).coerceIn(-1.0, 1.0) else 0.0,
            turn = if (isMoving) turn + tremor * 0.5 else 0.0,
            highGear = highGear,
            state = order.state,
            obstacle = obstacle(order.task, time),
            pieceAfter = pieceAfter,
        )
    }

    private fun setTargets(task: Task, drivetrain: Drivetrain) = when (task) {
        Task.Wait -> hold(0.0, 0.0)

        Task.Creep -> hold(0.2, 0.0)

        Task.Push -> hold(1.0, 0.0)

        is Task.PushWall -> hold(task.throttle, 0.0)

        Task.BackOff -> hold(-0.4, 0.0)

        Task.Aim -> {
            highGear = false
            approach(Camera.TARGET_X, Camera.TARGET_Y, SCORING_DISTANCE, 0.35, drivetrain)
        }

        is Task.DriveTo -> approach(task.x, task.y, 0.0, style.fastest, drivetrain)
    }

    /** Turns to (x, y) and drives until the distance is [short] m, with at most [most] throttle. */
    private fun approach(x: Double, y: Double, short: Double, most: Double, drivetrain: Drivetrain) {
        val dx = x - drivetrain.x
        val dy = y - drivetrain.y
        val distance = sqrt(dx * dx + dy * dy) - short
        // A driver who is close to the place does not turn around for the rest.
        if (distance < 0.5 && short == 0.0) hasArrived = true
        if (hasArrived) return hold(0.0, 0.0)
        if (distance > 3) highGear = true
        val error = wrapped(direction(dx, dy) - drivetrain.heading)
        val ahead = maxOf(0.0, cosine(error))
        val throttle = if (distance < 0.08) 0.0 else (distance * 0.3).coerceAtMost(most) * ahead * ahead
        hold(throttle, if (abs(error) < 0.02 && throttle == 0.0) 0.0 else (error * 1.1).coerceIn(-0.5, 0.5))
    }

    // While the robot begins to back off, the other robot still holds it.
    private fun obstacle(task: Task, time: Double) = when {
        task is Task.PushWall -> WALL
        task == Task.Push || (task == Task.BackOff && throttle > 0) -> defender(time)
        else -> 0.0
    }

    private fun defender(time: Double) = 4000 + 1500 * sine(time * 3.1)

    private fun hold(wantedThrottle: Double, wantedTurn: Double) {
        throttle = moved(throttle, wantedThrottle, style.ramp)
        turn = moved(turn, wantedTurn, 2 * style.ramp)
    }

    private fun moved(now: Double, wanted: Double, rate: Double): Double {
        val most = rate * loopSeconds
        return now + (wanted - now).coerceIn(-most, most)
    }
}

// The resistance of a wall, in N·s/m, like the robot's obstacle.
private const val WALL = 12_000.0
private const val SCORING_DISTANCE = 1.25
