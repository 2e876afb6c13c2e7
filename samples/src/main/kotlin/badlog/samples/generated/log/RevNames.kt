package badlog.samples.generated.log

import badlog.samples.generated.fault.Signal
import badlog.samples.generated.robot.Device
import badlog.samples.generated.robot.MatchRun
import kotlin.math.PI

/**
 * The topics of a revlog, with the Driver Station's part of a WPILib log. A revlog has every status signal of each Spark, each time a frame
 * arrives.
 */
internal fun revTopics(run: MatchRun): List<LoggedTopic> = TopicList().apply {
    val robot = run.robot
    station(run)
    for (device in robot.devices) {
        spark(device, device.motor.id)
        // A second motor follows the first.
        if (device.motor.count > 1) spark(device, device.motor.id + FOLLOWER)
    }
    robot.elevator?.run {
        truth("REV/Spark-${device.motor.id}/HARD_REVERSE_LIMIT_REACHED", Signal.LIMIT_SWITCH, "Elevator") { isSwitchPressed }
    }
    robot.arm?.run {
        frame(device, "REV/Spark-${device.motor.id}/DUTY_CYCLE_ENCODER_POSITION", Signal.ABSOLUTE_ENCODER, 2) { measured / (2 * PI) + 0.25 }
    }
    for (wheel in robot.drive.wheels) {
        val steer = wheel.steer ?: continue
        frame(steer, "REV/Spark-${steer.motor.id}/DUTY_CYCLE_ENCODER_POSITION", Signal.ABSOLUTE_ENCODER, 2) {
            val turns = wheel.measuredAngle / (2 * PI)
            turns - kotlin.math.floor(turns)
        }
    }
}.topics

private const val FOLLOWER = 30

private fun TopicList.frame(device: Device, name: String, signal: Signal?, every: Int, read: () -> Double) {
    var seen = 0
    number(name, signal, device.motor.part, every = 0) {
        val isNew = device.frames - seen >= every
        if (isNew) seen = device.frames
        if (isNew) read() else null
    }
}

private fun TopicList.spark(device: Device, id: Int) {
    val name = "REV/Spark-$id"
    val part = device.motor.part
    frame(device, "$name/APPLIED_OUTPUT", Signal.MOTOR_OUTPUT, 1) { device.output }
    frame(device, "$name/VOLTAGE", Signal.BATTERY_VOLTAGE, 2) { device.supplyVolts }
    frame(device, "$name/CURRENT", Signal.MOTOR_CURRENT, 1) { kotlin.math.abs(device.statorCurrent) }
    frame(device, "$name/MOTOR_TEMPERATURE", Signal.MOTOR_TEMPERATURE, 5) { device.temperature }
    frame(device, "$name/PRIMARY_ENCODER_VELOCITY", Signal.MOTOR_VELOCITY, 2) { device.rpm }
    frame(device, "$name/PRIMARY_ENCODER_POSITION", Signal.MOTOR_POSITION, 2) { device.position }
    truth("$name/TEMPERATURE_FAULT", Signal.MOTOR_TEMPERATURE, part, every = 12) { device.temperature > 100 }
    truth("$name/BROWNOUT_WARNING", Signal.BROWNED_OUT, part, every = 12) { device.supplyVolts < 6.0 }
}
