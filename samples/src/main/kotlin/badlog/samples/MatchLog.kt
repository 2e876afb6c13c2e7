package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Elevator
import badlog.samples.robot.RoboRio

/** Creates all topics of a match, in the order of the robot's program. */
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

/** Returns the values that the field sends to the robot before a match, and the battery's label. */
fun matchValues(start: String, number: String, alliance: String, location: String, battery: String) = listOf(
    "Start Time" to start,
    "Event Name" to "Mill Creek Regional",
    "Match Type" to "Qualification",
    "Match Number" to number,
    "Alliance" to alliance,
    "Location" to location,
    "System/Battery Label" to battery,
)

/** The values that are the same in every sample log. */
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
