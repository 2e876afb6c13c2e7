package badlog.samples.fault

import badlog.samples.bag.BagLog
import badlog.samples.createDrivetrainTopics
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Noise
import badlog.samples.robot.Robot
import badlog.samples.robot.Side
import kotlin.math.abs

/** The chassis of a robot, and its topics in the log. */
internal enum class Chassis {
    /** Two gearboxes with two motors each. */
    TANK {
        override val signals = linked("Drivetrain/Left") + linked("Drivetrain/Right")

        override val motorsPerGearbox get() = 2

        override fun createTopics(log: BagLog, robot: Robot, mishaps: Mishaps, noise: Noise): (time: Double) -> Unit {
            log.createDrivetrainTopics(robot)
            for ((side, channels) in listOf("Left" to (0 to 1), "Right" to (14 to 15))) {
                log.number("Drivetrain/$side Current", "A", 3) { robot.power.measuredAmps(channels.first) }
                log.number("Drivetrain/$side Follower Current", "A", 3) { robot.power.measuredAmps(channels.second) }
            }
            return {}
        }
    },

    /** Four modules with a drive motor each; two motors lift the elevator. */
    SWERVE {
        override val signals = linked("Elevator/Leader", "Elevator/Follower")

        override val motorsPerGearbox get() = 1

        override fun createTopics(log: BagLog, robot: Robot, mishaps: Mishaps, noise: Noise): (time: Double) -> Unit {
            val modules = listOf(
                SwerveModule("Front Left", Side.LEFT, 0, robot, mishaps, noise),
                SwerveModule("Back Left", Side.LEFT, 1, robot, mishaps, noise),
                SwerveModule("Front Right", Side.RIGHT, 0, robot, mishaps, noise),
                SwerveModule("Back Right", Side.RIGHT, 1, robot, mishaps, noise),
            )
            for (module in modules) module.createTopics(log)
            log.number("Swerve/Heading", "deg", 2) { robot.gyro.angle }
            log.number("Elevator/Leader Current", "A", 3) { robot.power.measuredAmps(LEADER) }
            log.number("Elevator/Follower Current", "A", 3) { robot.power.measuredAmps(FOLLOWER) }
            return { time -> modules.forEach { it.measure(time) } }
        }
    },
    ;

    /** The groups of motors that turn together, as in a team's `badlog-signals.toml`. */
    abstract val signals: String

    /** The number of motors that stand still when one gearbox is stuck. */
    abstract val motorsPerGearbox: Int

    /** Creates the topics of the chassis; returns a function to call in each loop with the loop's time. */
    abstract fun createTopics(log: BagLog, robot: Robot, mishaps: Mishaps, noise: Noise): (time: Double) -> Unit

    protected fun linked(one: String, other: String = "$one Follower") = "[[linked]]\nmotors = [\"$one\", \"$other\"]\n\n"
}

/** One of four modules: motor [motor] of [side]. A fault of a side affects its first module. */
private class SwerveModule(
    private val name: String,
    private val side: Side,
    private val motor: Int,
    private val robot: Robot,
    private val mishaps: Mishaps,
    private val noise: Noise,
) {
    private var position = 0.0
    private var velocity = 0.0
    private var last = 0.0

    fun createTopics(log: BagLog) {
        val channel = (if (side == Side.LEFT) 0 else 14) + motor
        log.number("Swerve/$name/Drive Output", "ul", 3) {
            if (side == Side.LEFT) robot.drivetrain.leftOutput else robot.drivetrain.rightOutput
        }
        log.number("Swerve/$name/Drive Position", "m", 4) { position }
        log.number("Swerve/$name/Drive Velocity", "m/s", 3) { velocity }
        log.number("Swerve/$name/Drive Current", "A", 3) { robot.power.measuredAmps(channel) }
    }

    fun measure(time: Double) {
        val seconds = time - last
        last = time
        if (mishaps.canIsCut(time)) return
        if (motor == 0 && side in mishaps.blindSides(time)) {
            velocity = 0.0
            return
        }
        val drivetrain = robot.drivetrain
        val isStuck = motor == 0 && drivetrain.seized?.side == side
        // The front wheels lead into a turn, the rear ones follow.
        val lead = drivetrain.turnRate * if (motor == 0) LEAD else -LEAD
        val rolling = (
            if (side == Side.LEFT) drivetrain.leftVelocity else drivetrain.rightVelocity
            ).let { if (abs(it) < RESTING) 0.0 else it + lead }
        val actual = if (isStuck) 0.0 else rolling
        position += actual * seconds
        velocity = if (actual == 0.0) 0.0 else actual + noise.around(DEVIATION)
    }
}

private const val LEADER = 2
private const val FOLLOWER = 13

private const val LEAD = 0.05
private const val RESTING = 0.002
private const val DEVIATION = 0.01
