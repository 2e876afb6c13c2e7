package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.bag.NumberText
import badlog.samples.bag.cutInLastRow
import badlog.samples.bag.losePage
import badlog.samples.match.Order
import badlog.samples.match.Schedule
import badlog.samples.match.Task
import badlog.samples.robot.Battery
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Mishap
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Robot
import badlog.samples.robot.Superstructure

/**
 * Returns a practice run in which a battery lead works loose. The voltage dips three times; then a power cut ends the log in the middle of
 * a row. A page that the file system had not written yet is filled with NULs.
 */
fun practiceRun(): ByteArray {
    val mishaps = Mishaps(
        listOf(
            Mishap.LooseLead(18.9, 0.05),
            Mishap.LooseLead(35.7, 0.09),
            Mishap.LooseLead(42.9, 0.14),
        ),
    )
    val robot = Robot(
        seed = 7,
        battery = Battery(ohms = 0.0115, slowOhms = 0.0035, ampHours = 18.0, charge = 0.97),
        drivetrain = Drivetrain(x = 1.55, y = 3.0, heading = StrictMath.PI),
        pressure = 104.0,
        mishaps = mishaps,
    )
    val run = Run(seed = 7, robot, Schedule.practice(end = 45.4), practiceOrders(), mishaps)
    val log = BagLog(NumberText.FIVE_DIGITS, PRACTICE_VALUES + ROBOT_VALUES)
    log.createPracticeTopics(run)
    log.finishInitialization()
    run.loop { log.log() }
    return losePage(cutInLastRow(log.bytes(), share = 0.6), at = 0.92)
}

private fun practiceOrders(): List<Order> {
    val nearby = Task.DriveTo(10.2, 4.6)
    return listOf(Order(0.0, Task.Wait, Superstructure.STOWED)) +
        cycle(1.4, nearby) + cycle(18.2, nearby) + cycle(35.0, nearby)
}

// No match values and no single channels: the drivers only tested the driving.
private fun BagLog.createPracticeTopics(run: Run) {
    number("Time", "s", 6, "hide", "delta", "xaxis") { run.time }
    createSystemTopics(run.robot, run::nextEvent)
    createPowerTopics(run.robot, withChannels = false)
    createDrivetrainTopics(run.robot)
    createElevatorTopics(run.robot)
    createManipulatorTopics(run.robot)
}

private val PRACTICE_VALUES = listOf(
    "Start Time" to "2024-03-14T19:26:40",
    "Match Type" to "None",
    "Match Number" to "0",
    "System/Battery Label" to "B9, 2023",
)
