package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.robot.Mode
import badlog.samples.robot.Robot

// The topics that the robot's program creates, grouped by the part of the robot.

fun BagLog.createSystemTopics(robot: Robot, event: () -> String, loopMillis: () -> Double = { robot.roboRio.loopMillis }) {
    flag("System/Enabled") { robot.mode != Mode.DISABLED }
    flag("System/Autonomous") { robot.mode == Mode.AUTONOMOUS }
    flag("System/Browned Out") { robot.roboRio.isBrownedOut }
    number("System/Battery Voltage", "V", 2, "zero") { robot.roboRio.batteryVolts }
    number("System/CPU Load", "%", 1, "area", "zero") { robot.roboRio.cpuLoad }
    number("System/CAN Load", "%", 0) { robot.roboRio.canLoad }
    number("System/Loop Time", "ms", 2, "zero", supplier = loopMillis)
    text("System/Event Log", "log", supplier = event)
}

fun BagLog.createPowerTopics(robot: Robot, withChannels: Boolean) {
    number("PDP/Total Current", "A", 3, "area", "zero", "integrate") { robot.power.total }
    if (!withChannels) return
    for (channel in robot.power.channels.indices) {
        number("PDP/Current $channel", "A", 3, "hide", "join:Power/Currents") { robot.power.measuredAmps(channel) }
    }
}

fun BagLog.createDrivetrainTopics(robot: Robot) {
    val drivetrain = robot.drivetrain
    val sensors = robot.sensors
    number("Drivetrain/Left Output", "ul", 3, "hide", "join:Drivetrain/Outputs") { drivetrain.leftOutput }
    number("Drivetrain/Right Output", "ul", 3, "hide", "join:Drivetrain/Outputs") { drivetrain.rightOutput }
    number("Drivetrain/Left Position", "m", 4, "differentiate") { sensors.leftPosition }
    number("Drivetrain/Right Position", "m", 4, "differentiate") { sensors.rightPosition }
    number("Drivetrain/Left Velocity", "m/s", 3, "hide", "join:Drivetrain/Velocities") { sensors.leftVelocity }
    number("Drivetrain/Right Velocity", "m/s", 3, "hide", "join:Drivetrain/Velocities") { sensors.rightVelocity }
    number("Drivetrain/Angle", "deg", 2, "differentiate") { robot.gyro.angle }
    text("Drivetrain/Gear") { if (drivetrain.isHighGear) "HIGH" else "LOW" }
}

fun BagLog.createElevatorTopics(robot: Robot) {
    val elevator = robot.elevator
    val sensors = robot.sensors
    number("Elevator/Position", "m", 4, "zero", "join:Elevator/Tracking") { sensors.elevatorPosition }
    number("Elevator/Setpoint", "m", 4, "hide", "join:Elevator/Tracking") { elevator.profile.position }
    number("Elevator/Velocity", "m/s", 3) { sensors.elevatorVelocity }
    number("Elevator/Output", "ul", 3) { elevator.output }
    number("Elevator/Current", "A", 1, "area", "zero") { sensors.elevatorAmps }
    flag("Elevator/At Bottom") { elevator.isAtBottom }
    flag("Elevator/At Top") { elevator.isAtTop }
}

fun BagLog.createManipulatorTopics(robot: Robot) {
    number("Arm/Angle", "deg", 1, "join:Arm/Tracking") { robot.arm.angle }
    number("Arm/Setpoint", "deg", 1, "hide", "join:Arm/Tracking") { robot.arm.setpoint }
    number("Intake/Current", "A", 3, "area", "zero") { robot.power.measuredAmps(INTAKE_CHANNEL) }
    flag("Intake/Has Piece") { robot.intake.hasPiece }
    text("Superstructure/State") { robot.state.name }
}

fun BagLog.createFieldTopics(robot: Robot) {
    number("Vision/Target X", "deg", 2) { robot.camera.targetX }
    number("Vision/Latency", "ms", 1, "area", "zero") { robot.camera.latency }
    number("Pneumatics/Pressure", "psi", 1, "zero") { robot.pneumatics.pressure }
    flag("Pneumatics/Compressor On") { robot.pneumatics.isCompressing }
}

private const val INTAKE_CHANNEL = 12
