package badlog.samples.generated.log

import badlog.samples.generated.fault.Signal
import badlog.samples.generated.robot.Device
import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.Phase
import kotlin.math.PI
import kotlin.math.round

/** The topics of a hoot log of Phoenix 6: every status signal, each time a frame arrives, and the state of the drive. */
internal fun phoenixTopics(run: MatchRun): List<LoggedTopic> = TopicList().apply {
    val robot = run.robot
    truth("RobotEnable", Signal.ENABLED) { run.isEnabled }
    add("RobotMode", ValueType.Text, Signal.AUTONOMOUS) { if (run.phase <= Phase.AUTO) "Autonomous" else "Teleop" }
    for (device in robot.devices) {
        talon(device, device.motor.id, 1)
        // A second motor follows the first.
        if (device.motor.count > 1) talon(device, device.motor.id + FOLLOWER, 2)
    }
    setpoints(run)
    number("Phoenix6/Pigeon2-0/Yaw", Signal.GYRO, every = 0) { round(robot.gyro.yaw * 180 / PI * 128) / 128 }
    number("Phoenix6/Pigeon2-0/AngularVelocityZWorld", null, every = 0) { round(robot.gyro.rate * 180 / PI * 16) / 16 }
    number("Phoenix6/Pigeon2-0/AccelerationX", Signal.ACCELERATION, every = 0) { round(robot.gyro.acceleration / 9.81 * 256) / 256 }
    if (robot.isSwerve) {
        structs("DriveState/ModuleStates", Struct.MODULE_STATE, Signal.MEASURED, isArray = true) { moduleStates(robot.drive) }
        structs("DriveState/ModuleTargets", Struct.MODULE_STATE, Signal.SETPOINT, isArray = true) { moduleTargets(robot.drive) }
    }
    structs("DriveState/Pose", Struct.POSE_2D, Signal.POSE) { robot.odometry.run { doubleArrayOf(x, y, heading) } }
}.topics

private const val FOLLOWER = 30

/** Adds a topic with a value of [device] for each [every]th status frame that arrives. */
private fun TopicList.signal(device: Device, name: String, signal: Signal?, every: Int, read: () -> Double) {
    var seen = 0
    number(name, signal, device.motor.part, every = 0) {
        val isNew = device.frames - seen >= every
        if (isNew) seen = device.frames
        if (isNew) read() else null
    }
}

private fun TopicList.talon(device: Device, id: Int, every: Int) {
    val name = "Phoenix6/TalonFX-$id"
    val part = device.motor.part
    signal(device, "$name/Position", Signal.MOTOR_POSITION, 4 * every) { device.position }
    signal(device, "$name/Velocity", Signal.MOTOR_VELOCITY, 2 * every) { device.rpm / 60 }
    signal(device, "$name/DutyCycle", null, 4 * every) { device.output }
    signal(device, "$name/MotorVoltage", Signal.MOTOR_OUTPUT, 2 * every) { device.output * device.supplyVolts }
    signal(device, "$name/StatorCurrent", Signal.MOTOR_CURRENT, 2 * every) { device.statorCurrent }
    signal(device, "$name/SupplyCurrent", Signal.SUPPLY_CURRENT, 2 * every) { device.supplyCurrent }
    signal(device, "$name/SupplyVoltage", Signal.BATTERY_VOLTAGE, 4 * every) { device.supplyVolts }
    signal(device, "$name/DeviceTemp", Signal.MOTOR_TEMPERATURE, 25) { device.temperature }
    truth("$name/Fault_DeviceTemp", Signal.MOTOR_TEMPERATURE, part, every = 5) { device.temperature > 100 && device.isConnected }
    truth("$name/Fault_Undervoltage", Signal.BROWNED_OUT, part, every = 5) { device.supplyVolts < 6.5 }
}

private fun TopicList.setpoints(run: MatchRun) {
    val robot = run.robot
    for (wheel in robot.drive.wheels) {
        val steer = wheel.steer ?: continue
        val part = steer.motor.part
        signal(steer, "Phoenix6/CANcoder-${steer.motor.id}/AbsolutePosition", Signal.ABSOLUTE_ENCODER, 2) {
            round(wheel.measuredAngle / (2 * PI) * 4096) / 4096
        }
        number("Phoenix6/TalonFX-${steer.motor.id}/ClosedLoopReference", Signal.SETPOINT, part) { wheel.angleTarget / (2 * PI) }
    }
    robot.elevator?.run {
        val name = "Phoenix6/TalonFX-${device.motor.id}"
        val perTurn = 2 * PI / device.motor.gear * 0.0222
        number("$name/ClosedLoopReference", Signal.SETPOINT, "Elevator") { profile.position / perTurn }
        number("$name/ClosedLoopError", Signal.MEASURED, "Elevator") { (profile.position - measured) / perTurn }
        add("$name/ReverseLimit", ValueType.Whole, Signal.LIMIT_SWITCH, "Elevator") { if (isSwitchPressed) 0L else 1L }
    }
    robot.arm?.run {
        val name = "Phoenix6/TalonFX-${device.motor.id}"
        number("$name/ClosedLoopReference", Signal.SETPOINT, "Arm") { setpoint / (2 * PI) }
        number("$name/ClosedLoopError", Signal.MEASURED, "Arm") { (setpoint - measured) / (2 * PI) }
        number("Phoenix6/CANcoder-${device.motor.id + 10}/AbsolutePosition", Signal.ABSOLUTE_ENCODER, "Arm", every = 0) {
            if (isEncoderConnected) measured / (2 * PI) else null
        }
    }
    robot.shooter?.run {
        number("Phoenix6/TalonFX-${device.motor.id}/ClosedLoopReference", Signal.SETPOINT, "Shooter") { setpoint / 60 }
        number("Phoenix6/TalonFX-${device.motor.id}/ClosedLoopError", Signal.MEASURED, "Shooter") { (setpoint - measured) / 60 }
    }
}
