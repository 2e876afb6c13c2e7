package badlog.samples.generated.robot

import kotlin.math.max
import kotlin.math.round

/** The robot's computer, which decides the times and durations of loops. */
internal class Computer(private val chance: Chance, hasVision: Boolean) {
    private val usual = chance.between(4.0, 8.0)
    private val visionMillis = if (hasVision) 1.2 else 0.0

    /** The load that the robot's code and its system need, 0 to 1. */
    private val usualLoad = chance.between(0.35, 0.58)

    /** Load by other programs, 0 to 1. */
    var otherLoad = 0.0

    /** The time for which a new frame of the camera blocks the loop, in ms. */
    var cameraMillis = 0.0

    /** The garbage collector's pause in the next loop, in ms. */
    var pendingPause = 0.0

    /** The start of the next loop, in s. */
    var nextLoop = 0.0
        private set
    private var scheduled = 0.0

    /** The duration of the last loop and of its parts, in ms. */
    var userMillis = 0.0
        private set
    var visionPart = 0.0
        private set
    var collectionMillis = 0.0
        private set

    /** The time between the starts of the last two loops, in ms. */
    var cycleMillis = 20.0
        private set
    var load = usualLoad
        private set
    var temperature = 46.0
        private set
    private var lastStart = -0.02

    /** Simulates a loop at [time]. */
    fun loop(time: Double, hasNewFrame: Boolean, isEnabled: Boolean) {
        cycleMillis = (time - lastStart) * 1000
        lastStart = time
        val total = (usualLoad + otherLoad + (if (isEnabled) 0.08 else 0.0) + chance.normal(0.025)).coerceIn(0.05, 1.0)
        load += (total - load) * 0.1
        // Waiting for the processor extends all parts of a loop.
        val waiting = 1 / (1.04 - (total).coerceAtMost(0.99)).coerceAtLeast(0.25)
        val hiccup = if (chance.isIn(0.0012)) chance.between(8.0, 22.0) else 0.0
        val noise = chance.normal(0.5)
        collectionMillis = pendingPause + if (chance.isIn(0.004)) chance.between(2.0, 7.0) else 0.0
        pendingPause = 0.0
        visionPart = visionMillis * waiting / 2 + if (hasNewFrame) cameraMillis else 0.0
        val crowd = if (otherLoad > 0) max(0.0, chance.normal(1.0) + 0.6) * otherLoad * 22 else 0.0
        userMillis = max(1.5, usual * waiting / 1.9 + noise + hiccup + visionPart + collectionMillis + crowd)
        temperature += (44 + 16 * load - temperature) * 0.0004
        scheduled += PERIOD
        nextLoop = max(scheduled + max(0.0, chance.normal(0.00012)), time + userMillis / 1000)
        // A few late loops are made up for immediately, but not many.
        if (nextLoop - scheduled > 3 * PERIOD) scheduled = nextLoop
    }

    val temperatureReading: Double get() = round(temperature * 10) / 10

    companion object {
        const val PERIOD = 0.02
    }
}
