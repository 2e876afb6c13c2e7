package badlog.samples.generated.log

import badlog.samples.generated.fault.Signal
import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.Phase
import badlog.samples.generated.robot.Robot
import kotlin.math.PI
import kotlin.math.round

private const val BOARD = "NT:/SmartDashboard"

/** The topics of a robot with WPILib's `DataLogManager`: the Driver Station, the console, and a dashboard as teams make them. */
internal fun wpilibTopics(run: MatchRun): List<LoggedTopic> = TopicList().apply {
    val robot = run.robot
    station(run)
    add("messages", ValueType.Text, Signal.CONSOLE) { consoleText(run) }
    power(robot)
    drive(robot)
    robot.camera?.let { camera ->
        add("$BOARD/Vision/Robot Pose", ValueType.Numbers, Signal.VISION_POSE) {
            doubleArrayOf(camera.x, camera.y, camera.heading * 180 / PI)
        }
    }
    mechanisms(robot)
}.topics

/** Adds the topics that WPILib logs about the Driver Station. */
internal fun TopicList.station(run: MatchRun) {
    truth("DS:enabled", Signal.ENABLED) { run.isEnabled }
    truth("DS:autonomous", Signal.AUTONOMOUS) { run.phase <= Phase.AUTO }
    truth("DS:test", null) { false }
    truth("DS:estop", null) { false }
    add("DS:joystick0/axes", ValueType.Floats, Signal.JOYSTICK) { axes(run) }
    add("NT:/FMSInfo/EventName", ValueType.Text, null) { "SIM" }
    add("NT:/FMSInfo/MatchType", ValueType.Whole, null) { 2L }
    add("NT:/FMSInfo/MatchNumber", ValueType.Whole, null) { matchNumber(run) }
}

private fun TopicList.power(robot: Robot) {
    number("$BOARD/PDH/Voltage", Signal.BATTERY_VOLTAGE) { round(robot.measuredVolts * 20) / 20 }
    number("$BOARD/PDH/TotalCurrent", Signal.TOTAL_CURRENT) { round(robot.totalCurrent) }
    number("$BOARD/Battery Voltage", Signal.BATTERY_VOLTAGE) { robot.measuredVolts }
    for (channel in robot.channels.indices) {
        val part = robot.devices.find { channel - it.motor.channel in 0 until it.motor.count }?.motor?.part
        val owner = part ?: if (channel == Robot.COMPRESSOR_CHANNEL) "Air" else "none"
        number("$BOARD/PDH/Chan$channel", Signal.CHANNEL_CURRENT, owner, every = 5) { robot.channels[channel] }
    }
}

private fun TopicList.drive(robot: Robot) {
    val drive = robot.drive
    number("$BOARD/Drive/Gyro Yaw", Signal.GYRO) { robot.gyro.yaw * 180 / PI }
    add("$BOARD/Field/Robot", ValueType.Numbers, Signal.POSE) { robot.odometry.run { doubleArrayOf(x, y, heading * 180 / PI) } }
    number("$BOARD/Drive/Accel X (g)", Signal.ACCELERATION) { robot.gyro.acceleration / 9.81 }
    for (wheel in drive.wheels) {
        val part = wheel.drive.motor.part
        val name = "$BOARD/Drive/${wheel.name.replace("Front", "Front ").replace("Back", "Back ")}"
        number("$name Velocity", Signal.MOTOR_VELOCITY, part) { wheel.measuredSpeed(drive.radius) }
        number("$name Setpoint", Signal.SETPOINT, part) { wheel.speedTarget }
        number("$name Motor Temp", Signal.MOTOR_TEMPERATURE, part, every = 5) { wheel.drive.temperature }
        val steer = wheel.steer
        if (steer == null) {
            number("$name Position", Signal.MOTOR_POSITION, part) { wheel.drive.position / wheel.drive.motor.gear * 2 * PI * drive.radius }
            number("$name Output", Signal.MOTOR_OUTPUT, part) { wheel.drive.output }
        } else {
            number("$name Angle", Signal.MEASURED, steer.motor.part) { wheel.measuredAngle * 180 / PI }
            number("$name Angle Setpoint", Signal.SETPOINT, steer.motor.part) { wheel.angleTarget * 180 / PI }
        }
    }
}

private fun TopicList.mechanisms(robot: Robot) {
    robot.elevator?.run {
        number("$BOARD/Elevator/Height (m)", Signal.MEASURED, "Elevator") { measured }
        number("$BOARD/Elevator/Setpoint (m)", Signal.SETPOINT, "Elevator") { profile.position }
        number("$BOARD/Elevator/Current", Signal.MOTOR_CURRENT, "Elevator") { device.statorCurrent }
        number("$BOARD/Elevator/Output", Signal.MOTOR_OUTPUT, "Elevator") { device.output }
        truth("$BOARD/Elevator/Bottom Limit", Signal.LIMIT_SWITCH, "Elevator") { isSwitchPressed }
    }
    robot.arm?.run {
        number("$BOARD/Arm/Angle (deg)", Signal.ABSOLUTE_ENCODER, "Arm") { measured * 180 / PI }
        number("$BOARD/Arm/Setpoint (deg)", Signal.SETPOINT, "Arm") { setpoint * 180 / PI }
        number("$BOARD/Arm/Motor Position (rot)", Signal.MOTOR_POSITION, "Arm") { device.position }
        number("$BOARD/Arm/Motor Velocity (RPM)", Signal.MOTOR_VELOCITY, "Arm") { device.rpm }
        number("$BOARD/Arm/Current", Signal.MOTOR_CURRENT, "Arm") { device.statorCurrent }
    }
    robot.shooter?.run {
        number("$BOARD/Shooter/RPM", Signal.MEASURED, "Shooter") { measured }
        number("$BOARD/Shooter/Target RPM", Signal.SETPOINT, "Shooter") { setpoint }
        number("$BOARD/Shooter/Current", Signal.MOTOR_CURRENT, "Shooter") { device.statorCurrent }
    }
    robot.intake?.run {
        number("$BOARD/Intake/RPM", Signal.MOTOR_VELOCITY, "Intake") { device.rpm / device.motor.gear }
        number("$BOARD/Intake/Current", Signal.MOTOR_CURRENT, "Intake") { device.statorCurrent }
        truth("$BOARD/Intake/Has Piece", Signal.GAME_PIECE, "Intake") { hasPiece }
    }
    robot.air?.run {
        number("$BOARD/Pneumatics/Pressure (psi)", Signal.PRESSURE, "Air", every = 5) { measured }
        truth("$BOARD/Pneumatics/Compressor On", Signal.COMPRESSOR, "Air", every = 5) { isOn }
    }
}
