package badlog.samples.generated.log

import badlog.samples.generated.fault.Signal
import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.Phase
import badlog.samples.generated.robot.Robot
import kotlin.math.PI

/** The topics of a bag as teams wrote it in badlog's first years. */
internal fun badlogTopics(run: MatchRun): List<LoggedTopic> = TopicList().apply {
    val robot = run.robot
    number("Time", Signal.TIME, unit = "s", attributes = listOf("hide", "xaxis")) { 0.0 }
    number("System/Battery Voltage", Signal.BATTERY_VOLTAGE, unit = "V") { robot.measuredVolts }
    truth("System/Browned Out", Signal.BROWNED_OUT) { run.isBrownedOut }
    truth("System/Enabled", Signal.ENABLED) { run.isEnabled }
    truth("System/Autonomous", Signal.AUTONOMOUS) { run.phase <= Phase.AUTO }
    number("System/Loop Time", Signal.LOOP_TIME, unit = "ms") { robot.computer.cycleMillis }
    number("System/CPU Usage", Signal.CPU_LOAD, unit = "%", every = 5) { robot.computer.load * 100 }
    number("System/CAN Utilization", Signal.CAN_UTILIZATION, unit = "%", every = 5) { robot.bus.utilization * 100 }
    for (channel in robot.channels.indices) {
        val part = robot.devices.find { channel - it.motor.channel in 0 until it.motor.count }?.motor?.part
        val owner = part ?: if (channel == Robot.COMPRESSOR_CHANNEL) "Air" else continue
        number("PDP/Current $channel", Signal.CHANNEL_CURRENT, owner, "A", attributes = listOf("hide", "join:PDP/Currents")) {
            robot.channels[channel]
        }
    }
    number("PDP/Total Current", Signal.TOTAL_CURRENT, unit = "A") { robot.totalCurrent }
    drive(run)
    mechanisms(robot)
}.topics

private fun TopicList.drive(run: MatchRun) {
    val robot = run.robot
    val drive = robot.drive
    for (wheel in drive.wheels) {
        val part = wheel.drive.motor.part
        val name = "Drivetrain/" + wheel.name.replace("Front", "Front ").replace("Back", "Back ")
        number("$name Output Percent", Signal.MOTOR_OUTPUT, part, "%", attributes = listOf("hide", "join:Drivetrain/Output Percents")) {
            wheel.drive.output * 100
        }
        number("$name Velocity", Signal.MOTOR_VELOCITY, part, "m/s", attributes = listOf("hide", "join:Drivetrain/Velocities")) {
            wheel.measuredSpeed(drive.radius)
        }
        number("$name Target Velocity", Signal.SETPOINT, part, "m/s") { wheel.speedTarget }
        val steer = wheel.steer ?: continue
        number("$name Angle", Signal.MEASURED, steer.motor.part, "deg") { wheel.measuredAngle * 180 / PI }
        number("$name Target Angle", Signal.SETPOINT, steer.motor.part, "deg") { wheel.angleTarget * 180 / PI }
    }
    number("Drivetrain/Gyro Angle", Signal.GYRO, unit = "deg") { robot.gyro.yaw * 180 / PI }
    number("Drivetrain/Pose X", Signal.POSE, unit = "m") { robot.odometry.x }
    number("Drivetrain/Pose Y", Signal.POSE, unit = "m") { robot.odometry.y }
    number("Driver/Throttle", Signal.JOYSTICK) { axes(run).getOrElse(1) { 0.0 } }
    number("Driver/Turn", Signal.JOYSTICK) { axes(run).getOrElse(4) { 0.0 } }
}

private fun TopicList.mechanisms(robot: Robot) {
    robot.elevator?.run {
        number("Elevator/Height", Signal.MEASURED, "Elevator", "m") { measured }
        number("Elevator/Target Height", Signal.SETPOINT, "Elevator", "m") { profile.position }
        number("Elevator/Output Percent", Signal.MOTOR_OUTPUT, "Elevator", "%") { device.output * 100 }
        truth("Elevator/Bottom Switch", Signal.LIMIT_SWITCH, "Elevator") { isSwitchPressed }
    }
    robot.arm?.run {
        number("Arm/Angle", Signal.MEASURED, "Arm", "deg") { measured * 180 / PI }
        number("Arm/Target Angle", Signal.SETPOINT, "Arm", "deg") { setpoint * 180 / PI }
        number("Arm/Output Percent", Signal.MOTOR_OUTPUT, "Arm", "%") { device.output * 100 }
    }
    robot.shooter?.run {
        number("Shooter/Velocity", Signal.MEASURED, "Shooter", "RPM") { measured }
        number("Shooter/Target Velocity", Signal.SETPOINT, "Shooter", "RPM") { setpoint }
        number("Shooter/Output Percent", Signal.MOTOR_OUTPUT, "Shooter", "%") { device.output * 100 }
    }
    robot.intake?.run {
        number("Intake/Output Percent", Signal.MOTOR_OUTPUT, "Intake", "%") { device.output * 100 }
        number("Intake/Velocity", Signal.MOTOR_VELOCITY, "Intake", "RPM") { device.rpm / device.motor.gear }
        truth("Intake/Has Piece", Signal.GAME_PIECE, "Intake") { hasPiece }
    }
    robot.air?.run {
        number("Pneumatics/Pressure", Signal.PRESSURE, "Air", "psi") { measured }
        truth("Pneumatics/Compressor", Signal.COMPRESSOR, "Air") { isOn }
    }
}
