package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Elevator
import badlog.samples.robot.RoboRio

/** All topics of a match, in the order in which the robot's program creates them. */
fun BagLog.createMatchTopics(run: Run) {
    val robot = run.robot
    number("Time", "s", 6, "hide", "delta", "xaxis") { run.time }
    number("Match Time", "s", 0) { run.matchSecondsLeft.toDouble() }
    createSystemTopics(robot, run::nextEvent)
    createPowerTopics(robot, withChannels = true)
    createDrivetrainTopics(robot)
    createElevatorTopics(robot)
    createManipulatorTopics(robot)
    createFieldTopics(robot)
}

/** What the field sends to the robot before a match, and the label of the battery. */
fun matchValues(start: String, number: String, alliance: String, location: String, battery: String) = listOf(
    "Start Time" to start,
    "Event Name" to "Mill Creek Regional",
    "Match Type" to "Qualification",
    "Match Number" to number,
    "Alliance" to alliance,
    "Location" to location,
    "System/Battery Label" to battery,
)

/** What is the same whatever the robot does. */
val ROBOT_VALUES = listOf(
    "System/Software Version" to "v2024.3.2",
    "System/Brownout Voltage" to "${RoboRio.BROWNOUT_VOLTS}",
    "Drivetrain/Wheel Diameter" to "${Drivetrain.WHEEL_DIAMETER}",
    "Drivetrain/Gear Ratios" to "${Drivetrain.LOW_RATIO} : 1 low, ${Drivetrain.HIGH_RATIO} : 1 high",
    "Drivetrain/Current Limit" to "none",
    "Elevator/P" to "${Elevator.GAIN}",
    "Elevator/I" to "0.0",
    "Elevator/D" to "0.0",
    "Elevator/F" to "${Elevator.PER_VELOCITY}",
)
