package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.bag.NumberText
import badlog.samples.match.Order
import badlog.samples.match.Schedule
import badlog.samples.match.Task
import badlog.samples.robot.Battery
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Mishap
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Robot
import badlog.samples.robot.Superstructure

/** The start of the push that the old battery cannot supply: 1:30 into the match. */
const val PUSH_BEGINS = 92.0

/** Returns a match with an old battery. In a pushing fight in high gear its voltage sags until the roboRIO cuts the outputs. */
fun qualification42(): ByteArray {
    val mishaps = Mishaps(
        listOf(
            Mishap.CanSilence(49.3, 0.26, "WARN: CAN timeout, Elevator (ID 5), no status frame for 100 ms"),
            Mishap.Stall(64.0, 0.127, "WARN: loop overrun, \"Vision.update\" took 127 ms"),
        ),
    )
    val robot = Robot(
        seed = 42,
        battery = Battery(ohms = 0.0195, slowOhms = 0.0072, ampHours = 12.5, charge = 0.93),
        drivetrain = Drivetrain(x = 1.55, y = 3.0, heading = StrictMath.PI),
        pressure = 119.0,
        mishaps = mishaps,
    )
    val orders = TWO_PIECE_AUTONOMOUS + cycle(19.3) + cycle(36.4) + cycle(53.6) + cycle(70.8) + pushingFight() +
        cycle(101.0) + cycle(118.3) + cycle(135.8)
    val run = Run(seed = 42, robot, Schedule.match(secondsAfter = 2.0), orders, mishaps)
    val values = matchValues("2024-03-16T10:41:07", "42", "Blue", "2", "B3, 2019") + ROBOT_VALUES
    val log = BagLog(NumberText.SENSOR_DECIMALS, values)
    log.createMatchTopics(run)
    log.finishInitialization()
    run.loop { log.log() }
    return log.bytes()
}

private fun pushingFight() = listOf(
    Order(88.0, Task.DriveTo(8.2, 4.0), Superstructure.STOWED),
    Order(PUSH_BEGINS, Task.Push, Superstructure.STOWED, "Driver: \"pushing through\""),
    Order(97.2, Task.BackOff, Superstructure.STOWED),
    Order(98.2, Task.Wait, Superstructure.STOWED),
)
