package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.bag.NumberText
import badlog.samples.match.Order
import badlog.samples.match.Schedule
import badlog.samples.match.Task
import badlog.samples.robot.Battery
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Noise
import badlog.samples.robot.Robot
import badlog.samples.robot.Superstructure
import badlog.samples.robot.degrees
import badlog.samples.robot.wrapped

/** The second from which the robot's target is mirrored, so that it turns to the wrong side. */
const val WRONG_TURN = 7.6

/**
 * Returns an autonomous run over three places, with its planned path. The third place is the other alliance's, so that the robot turns to
 * the wrong side.
 */
fun wrongTurn(): ByteArray {
    val plan = ArrayList<DoubleArray>()
    runTo(THIRD_Y).let { run -> run.loop { plan += placeOf(run.robot) } }
    val run = runTo(MIRRORED_Y)
    val noise = Noise(seed = 11)
    var loop = 0
    val log = BagLog(NumberText.SENSOR_DECIMALS, matchValues("2024-03-16T11:52:30", "46", "Blue", "1", "B7, 2023"))
    log.number("Time", "s", 6, "hide", "delta", "xaxis") { run.time }
    log.createSystemTopics(run.robot, run::nextEvent)
    log.number("PDP/Total Current", "A", 3, "area", "zero") { run.robot.power.total }
    log.createDrivetrainTopics(run.robot)
    for ((place, name) in listOf("X", "Y", "Heading").withIndex()) {
        val unit = if (name == "Heading") "deg" else "m"
        log.number("Drive/Pose $name", unit, 3, "hide", "join:Drive/Pose") { placeOf(run.robot)[place] }
        log.number("Drive/Target Pose $name", unit, 3, "hide", "join:Drive/Target Pose") { plan[loop][place] }
    }
    for ((place, name) in listOf("X", "Y").withIndex()) {
        // The camera sometimes sees a tag and reports a position slightly off the robot's.
        log.number("Vision/Pose $name", "m", 3, "hide") {
            (placeOf(run.robot)[place] + noise.around(SCATTER)).takeIf { loop % SEEN_EVERY == 0 }
        }
    }
    log.finishInitialization()
    run.loop {
        log.log()
        loop++
    }
    return log.bytes()
}

private fun runTo(thirdY: Double): Run {
    val robot = Robot(
        seed = 46,
        battery = Battery(ohms = 0.012, slowOhms = 0.0036, ampHours = 17.6, charge = 0.98),
        drivetrain = Drivetrain(x = 1.6, y = 4.0, heading = 0.0),
        pressure = 115.0,
        mishaps = Mishaps(),
    )
    val orders = listOf(
        Order(0.0, Task.Wait, Superstructure.STOWED),
        Order(2.2, Task.DriveTo(3.6, 4.0), Superstructure.STOWED),
        Order(4.6, Task.DriveTo(6.2, 4.6), Superstructure.STOWED),
        Order(WRONG_TURN, Task.DriveTo(THIRD_X, thirdY), Superstructure.INTAKING),
        Order(12.6, Task.DriveTo(4.0, 4.2), Superstructure.HOLDING),
    )
    return Run(seed = 46, robot, Schedule.autonomous(end = 18.0), orders, Mishaps())
}

private fun placeOf(robot: Robot) = doubleArrayOf(robot.drivetrain.x, robot.drivetrain.y, degrees(wrapped(robot.drivetrain.heading)))

private const val THIRD_X = 7.6
private const val THIRD_Y = 7.0

/** [THIRD_Y] for the other alliance. */
private const val MIRRORED_Y = 8.07 - THIRD_Y
private const val SCATTER = 0.06
private const val SEEN_EVERY = 5
