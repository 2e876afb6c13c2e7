package badlog.signals.logging

/**
 * A value that a robot program can log so that its log has a signal.
 *
 * @property topic the name of the topic, by which it is recognized as the signal.
 * @property unit its unit; `ul` for none, as in bags.
 * @property value the Java expression for its value.
 * @property isBoolean whether the value is true or false.
 */
internal class LoggedValue(val topic: String, val unit: String, val value: String, val isBoolean: Boolean)

/** Returns the line of Java with which [library] logs the signal [signal] of the built-in vocabulary. Null if there is none. */
fun howToLog(signal: String, library: LoggingLibrary): String? = LOGGED[signal]?.let(library::lineFor)

/** Returns whether only the Driver Station knows the signal [signal]. Its log is read together with the robot's. */
fun isOfDriverStation(signal: String): Boolean = signal in OF_DRIVER_STATION

/** The signals that [howToLog] knows. */
internal val LOGGED: Map<String, LoggedValue> = mapOf(
    "battery" to number("Battery Voltage", "V", "RobotController.getBatteryVoltage()"),
    "brownout" to condition("Browned Out", "RobotController.isBrownedOut()"),
    "brownout voltage" to number("Brownout Voltage", "V", "RobotController.getBrownoutVoltage()"),
    "total current" to number("PDP/Total Current", "A", "powerDistribution.getTotalCurrent()"),
    "channel current" to number("PDP/Current 0", "A", "powerDistribution.getCurrent(0)"),
    "rail faults" to number("3.3V Rail/Fault Count", "ul", "RobotController.getFaultCount3V3()"),
    "robot enabled" to condition("Robot/Enabled", "DriverStation.isEnabled()"),
    "robot autonomous" to condition("Robot/Autonomous", "DriverStation.isAutonomous()"),
    "robot teleop" to condition("Robot/Teleop", "DriverStation.isTeleop()"),
    "emergency stop" to condition("Robot/Emergency Stopped", "DriverStation.isEStopped()"),
    "FMS attached" to condition("Robot/FMS Attached", "DriverStation.isFMSAttached()"),
    "match time" to number("Robot/Match Time", "s", "DriverStation.getMatchTime()"),
    "link" to condition("Robot/DS Attached", "DriverStation.isDSAttached()"),
    "CAN load" to number("CAN Utilization", "%", "RobotController.getCANStatus().percentBusUtilization * 100"),
    "CAN errors" to number("CAN Receive Errors", "ul", "RobotController.getCANStatus().receiveErrorCount"),
    "CPU temperature" to number("CPU Temperature", "°C", "RobotController.getCPUTemp()"),
    "motor output" to number("Arm/Motor Output", "fraction", "motor.get()"),
    "motor voltage" to number("Arm/Motor Voltage", "V", "motor.getMotorVoltage().getValueAsDouble()"),
    "motor current" to number("Arm/Current", "A", "motor.getSupplyCurrent().getValueAsDouble()"),
    "stator current" to number("Arm/Stator Current", "A", "motor.getStatorCurrent().getValueAsDouble()"),
    "motor temperature" to number("Arm/Temperature", "°C", "motor.getDeviceTemp().getValueAsDouble()"),
    "motor velocity" to number("Arm/Velocity", "rot/s", "motor.getVelocity().getValueAsDouble()"),
    "motor position" to number("Arm/Position", "rot", "motor.getPosition().getValueAsDouble()"),
    "setpoint" to number("Arm/Setpoint", "rot", "motor.getClosedLoopReference().getValueAsDouble()"),
    "measurement" to number("Arm/Position", "rot", "motor.getPosition().getValueAsDouble()"),
    "gyro angle" to number("Gyro/Angle", "deg", "gyro.getYaw().getValueAsDouble()"),
    "air pressure" to number("Pneumatics/Pressure", "psi", "compressor.getPressure()"),
    "compressor" to condition("Pneumatics/Compressor", "compressor.isEnabled()"),
)

private val OF_DRIVER_STATION = setOf("trip time", "packet loss", "wireless signal", "CPU load", "free memory", "free disk")

private fun number(topic: String, unit: String, value: String) = LoggedValue(topic, unit, value, isBoolean = false)

private fun condition(topic: String, value: String) = LoggedValue(topic, "ul", value, isBoolean = true)
