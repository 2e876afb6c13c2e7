package badlog.samples.generated.log

import badlog.samples.generated.fault.Signal
import badlog.samples.generated.robot.Air
import badlog.samples.generated.robot.Arm
import badlog.samples.generated.robot.Camera
import badlog.samples.generated.robot.Device
import badlog.samples.generated.robot.Elevator
import badlog.samples.generated.robot.Intake
import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.Phase
import badlog.samples.generated.robot.Shooter
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** The topics of a robot with AdvantageKit: names as in its templates and its `LoggedRobot`. */
internal fun advantageKitTopics(run: MatchRun): List<LoggedTopic> = TopicList().apply {
    val robot = run.robot
    system(run)
    stationInputs(run)
    if (robot.isSwerve) swerve(run) else tank(run)
    structs("/Drive/Gyro/YawPosition", Struct.ROTATION_2D, Signal.GYRO) { doubleArrayOf(robot.gyro.yaw) }
    number("/Drive/Gyro/YawVelocityRadPerSec", null) { robot.gyro.rate }
    number("/Drive/Gyro/AccelerationX", Signal.ACCELERATION, unit = "m/s²") { robot.gyro.acceleration }
    truth("/Drive/Gyro/Connected", null) { true }
    structs("/RealOutputs/Odometry/Robot", Struct.POSE_2D, Signal.POSE) { robot.odometry.run { doubleArrayOf(x, y, heading) } }
    robot.camera?.let { camera(it) }
    robot.elevator?.let { elevator(it) }
    robot.arm?.let { arm(it) }
    robot.shooter?.let { shooter(it) }
    robot.intake?.let { intake(it) }
    robot.air?.let { air(it) }
}.topics

private fun TopicList.system(run: MatchRun) {
    val robot = run.robot
    val computer = robot.computer
    number("/SystemStats/BatteryVoltage", Signal.BATTERY_VOLTAGE) { robot.measuredVolts }
    number("/SystemStats/BatteryCurrent", null) { robot.standby * 0.4 }
    truth("/SystemStats/BrownedOut", Signal.BROWNED_OUT) { run.isBrownedOut }
    number("/SystemStats/BrownoutVoltage", null) { if (robot.isSecondRio) 6.75 else 6.3 }
    number("/SystemStats/CPUTempCelsius", Signal.CPU_TEMPERATURE) { computer.temperatureReading }
    number("/SystemStats/CANBus/Utilization", Signal.CAN_UTILIZATION) { robot.bus.utilization }
    add("/SystemStats/CANBus/ReceiveErrorCount", ValueType.Whole, Signal.CAN_ERRORS) { robot.bus.receiveErrors.toLong() }
    add("/SystemStats/CANBus/OffCount", ValueType.Whole, Signal.CAN_ERRORS) { robot.bus.busOff.toLong() }
    number("/SystemStats/3v3Rail/Voltage", null) { 3.32 }
    number("/PowerDistribution/Voltage", Signal.BATTERY_VOLTAGE) { robot.measuredVolts }
    number("/PowerDistribution/TotalCurrent", Signal.TOTAL_CURRENT) { robot.totalCurrent }
    add("/PowerDistribution/ChannelCurrent", ValueType.Numbers, Signal.CHANNEL_CURRENT) { robot.channels.copyOf() }
    add("/PowerDistribution/Faults", ValueType.Whole, Signal.BREAKER_FAULT) {
        robot.devices.fold(0L) { bits, device -> if (device.motor.isPowered) bits else bits or (1L shl device.motor.channel) }
    }
    number("/RealOutputs/LoggedRobot/FullCycleMS", Signal.LOOP_TIME) { computer.userMillis + 0.9 }
    number("/RealOutputs/LoggedRobot/UserCodeMS", Signal.LOOP_TIME) { computer.userMillis }
    number("/RealOutputs/LoggedRobot/LogPeriodicMS", null) { 0.9 }
    number("/RealOutputs/LoggedRobot/GCTimeMS", Signal.COLLECTION_TIME) { computer.collectionMillis }
    if (robot.camera != null) number("/RealOutputs/LoggedTracer/VisionMS", Signal.VISION_TIME) { computer.visionPart }
    add("/RealOutputs/Console", ValueType.Text, Signal.CONSOLE) { consoleText(run) }
    truth("/RadioStatus/Connected", Signal.LINK, every = 50) { run.isLinked }
    add("/RealOutputs/Alerts/errors", ValueType.Texts, Signal.MOTOR_CONNECTED) {
        robot.devices.filter { !it.isConnected }.map { "Disconnected motor ${it.motor.part} (ID ${it.motor.id})." }
    }
    add("/RealMetadata/ProjectName", ValueType.Text, null) { "Robot" }
}

private fun TopicList.stationInputs(run: MatchRun) {
    val driver = run.robot.driver
    truth("/DriverStation/Enabled", Signal.ENABLED) { run.isEnabled }
    truth("/DriverStation/Autonomous", Signal.AUTONOMOUS) { run.phase <= Phase.AUTO }
    truth("/DriverStation/Test", null) { false }
    truth("/DriverStation/EmergencyStop", null) { false }
    truth("/DriverStation/FMSAttached", Signal.LINK) { run.isLinked }
    truth("/DriverStation/DSAttached", Signal.LINK) { run.isLinked }
    add("/DriverStation/EventName", ValueType.Text, null) { "SIM" }
    add("/DriverStation/MatchType", ValueType.Whole, null) { 2L }
    add("/DriverStation/MatchNumber", ValueType.Whole, null) { matchNumber(run) }
    add("/DriverStation/Joystick0/Name", ValueType.Text, null) { if (driver.isPluggedIn) "Controller (XBOX 360 For Windows)" else "" }
    add("/DriverStation/Joystick0/AxisValues", ValueType.Floats, Signal.JOYSTICK) { axes(run) }
}

private fun TopicList.swerve(run: MatchRun) {
    val drive = run.robot.drive
    for ((index, wheel) in drive.wheels.withIndex()) {
        val name = "/Drive/Module$index"
        motor("$name/Drive", wheel.drive, hasTemperature = true)
        val steer = wheel.steer ?: continue
        motor("$name/Turn", steer, hasTemperature = false, hasPosition = false)
        val part = steer.motor.part
        structs("$name/TurnPosition", Struct.ROTATION_2D, Signal.MOTOR_POSITION, part) { doubleArrayOf(wheel.measuredAngle) }
        structs("$name/TurnAbsolutePosition", Struct.ROTATION_2D, Signal.ABSOLUTE_ENCODER, part) { doubleArrayOf(wheel.measuredAngle) }
    }
    structs("/RealOutputs/SwerveStates/Measured", Struct.MODULE_STATE, Signal.MEASURED, isArray = true) { moduleStates(drive) }
    structs("/RealOutputs/SwerveStates/SetpointsOptimized", Struct.MODULE_STATE, Signal.SETPOINT, isArray = true) { moduleTargets(drive) }
}

private fun TopicList.tank(run: MatchRun) {
    val drive = run.robot.drive
    for (wheel in drive.wheels) {
        motor("/Drive/${wheel.name}", wheel.drive, hasTemperature = true)
        number("/RealOutputs/Drive/${wheel.name}SetpointMetersPerSec", Signal.SETPOINT, wheel.drive.motor.part) { wheel.speedTarget }
    }
}

private fun TopicList.camera(camera: Camera) {
    truth("/Vision/Camera0/Connected", null) { true }
    var seen = 0
    structs("/RealOutputs/Vision/Camera0/RobotPosesAccepted", Struct.POSE_3D, Signal.VISION_POSE, isArray = true) {
        val isNew = camera.count != seen
        seen = camera.count
        if (isNew) doubleArrayOf(camera.x, camera.y, 0.0, cos(camera.heading / 2), 0.0, 0.0, sin(camera.heading / 2)) else DoubleArray(0)
    }
}

private fun TopicList.motor(name: String, device: Device, hasTemperature: Boolean, hasPosition: Boolean = true) {
    val part = device.motor.part
    truth("${name}Connected", Signal.MOTOR_CONNECTED, part) { device.isConnected }
    if (hasPosition) number("${name}PositionRad", Signal.MOTOR_POSITION, part) { device.position * 2 * PI / device.motor.gear }
    number("${name}VelocityRadPerSec", Signal.MOTOR_VELOCITY, part) { device.rpm * PI / 30 / device.motor.gear }
    number("${name}AppliedVolts", Signal.MOTOR_OUTPUT, part) { device.output * device.supplyVolts }
    number("${name}CurrentAmps", Signal.MOTOR_CURRENT, part) { device.statorCurrent }
    number("${name}SupplyCurrentAmps", Signal.SUPPLY_CURRENT, part) { device.supplyCurrent }
    if (hasTemperature) number("${name}TempCelsius", Signal.MOTOR_TEMPERATURE, part) { device.temperature }
}

private fun TopicList.elevator(elevator: Elevator) {
    motor("/Elevator/", elevator.device, hasTemperature = true)
    number("/Elevator/PositionMeters", Signal.MEASURED, "Elevator") { elevator.measured }
    truth("/Elevator/LowerLimit", Signal.LIMIT_SWITCH, "Elevator") { elevator.isSwitchPressed }
    number("/RealOutputs/Elevator/SetpointMeters", Signal.SETPOINT, "Elevator") { elevator.profile.position }
    number("/RealOutputs/Elevator/GoalMeters", Signal.SETPOINT, "Elevator") { elevator.profile.goal }
}

private fun TopicList.arm(arm: Arm) {
    motor("/Arm/", arm.device, hasTemperature = true)
    number("/Arm/AbsolutePositionRad", Signal.ABSOLUTE_ENCODER, "Arm") { arm.measured }
    truth("/Arm/EncoderConnected", Signal.ABSOLUTE_ENCODER, "Arm") { arm.isEncoderConnected }
    number("/RealOutputs/Arm/SetpointRad", Signal.SETPOINT, "Arm") { arm.setpoint }
}

private fun TopicList.shooter(shooter: Shooter) {
    motor("/Shooter/", shooter.device, hasTemperature = true)
    number("/Shooter/VelocityRPM", Signal.MEASURED, "Shooter") { shooter.measured }
    number("/RealOutputs/Shooter/SetpointRPM", Signal.SETPOINT, "Shooter") { shooter.setpoint }
}

private fun TopicList.intake(intake: Intake) {
    motor("/Intake/", intake.device, hasTemperature = false)
    truth("/Intake/BeamBreak", Signal.GAME_PIECE, "Intake") { intake.hasPiece }
}

private fun TopicList.air(air: Air) {
    number("/Pneumatics/PressurePSI", Signal.PRESSURE, "Air") { air.measured }
    truth("/Pneumatics/CompressorEnabled", Signal.COMPRESSOR, "Air") { air.isOn }
    number("/Pneumatics/CompressorCurrentAmps", Signal.COMPRESSOR, "Air") { air.current }
}
