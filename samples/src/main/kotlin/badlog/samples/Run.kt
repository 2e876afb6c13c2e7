package badlog.samples

import badlog.samples.match.Announcer
import badlog.samples.match.Driver
import badlog.samples.match.DrivingStyle
import badlog.samples.match.Order
import badlog.samples.match.Schedule
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Mode
import badlog.samples.robot.Noise
import badlog.samples.robot.Robot

/** A robot that runs through a schedule, loop by loop. */
class Run(
    seed: Long,
    val robot: Robot,
    private val schedule: Schedule,
    orders: List<Order>,
    private val mishaps: Mishaps,
    style: DrivingStyle = DrivingStyle(),
) {
    private val noise = Noise(seed xor 0x10CA1)
    private val driver = Driver(seed xor 0xD21FE2, orders, style)
    private val announcer = Announcer(robot, driver, mishaps)

    /** The time since the program started to log, in s. */
    var time = 0.0
        private set

    val matchSecondsLeft: Int get() = schedule.secondsLeft(time)

    fun nextEvent(): String = announcer.eventAt(time)

    /** Calls [afterLoop] at the end of each of the robot's loops. */
    fun loop(afterLoop: () -> Unit) {
        var seconds = PERIOD
        while (time < schedule.end) {
            val mode = if (mishaps.hasLink(time) && mishaps.programRuns(time)) schedule.modeAt(time) else Mode.DISABLED
            val sticks = driver.drive(time, seconds, mode != Mode.DISABLED, robot.drivetrain)
            robot.control(time, seconds, mode, sticks)
            afterLoop()
            seconds = PERIOD + noise.around(0.00025) + mishaps.stallSeconds(time)
            robot.pass(seconds)
            time += seconds
        }
    }
}

private const val PERIOD = 0.02
