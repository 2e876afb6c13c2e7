package badlog.formats.revlog

/**
 * A value in the eight bytes of a status frame.
 *
 * @property start its first bit, counted from the lowest of the first byte on.
 * @property length its length in bits.
 * @property unit its unit; empty if there is none, or if the robot's program defines it.
 * @property scale the factor for its number.
 */
internal class RevSignal(
    val name: String,
    val start: Int,
    val length: Int,
    val unit: String = "",
    val scale: Double = 1.0,
    val isSigned: Boolean = false,
    val isFloat: Boolean = false,
) {
    /** Whether it is on or off. */
    val isFlag: Boolean get() = length == 1

    /** Returns its number in [bits], the eight bytes of the frame. */
    fun read(bits: Long): Double {
        val unused = Long.SIZE_BITS - length
        val word = if (isSigned) bits shl (unused - start) shr unused else bits shl (unused - start) ushr unused
        return if (isFloat) Float.fromBits(word.toInt()).toDouble() else word * scale
    }
}

/**
 * A kind of REV device.
 *
 * @property name its name in topics.
 * @property frames the content of each status frame, by the frame's number.
 * @property version reads the firmware version from the bytes of the frame that has it.
 */
internal class RevDevice(val name: String, val frames: Map<Int, List<RevSignal>>, val version: (ByteArray, Int) -> String)

private fun unsigned(bytes: ByteArray, at: Int) = bytes[at].toInt() and 0xFF

private fun sparkFrames(): Map<Int, List<RevSignal>> = mapOf(
    0 to listOf(
        RevSignal("APPLIED_OUTPUT", 0, 16, scale = 0.00003082369457075716, isSigned = true),
        RevSignal("VOLTAGE", 16, 12, "V", 0.0073260073260073),
        RevSignal("CURRENT", 28, 12, "A", 0.0366300366300366),
        RevSignal("MOTOR_TEMPERATURE", 40, 8, "°C"),
    ) + flags(
        48,
        "HARD_FORWARD_LIMIT_REACHED",
        "HARD_REVERSE_LIMIT_REACHED",
        "SOFT_FORWARD_LIMIT_REACHED",
        "SOFT_REVERSE_LIMIT_REACHED",
        "INVERTED",
        "PRIMARY_HEARTBEAT_LOCK",
    ),
    1 to flags(0, *SPARK_FAULTS.map { "${it}_FAULT" }.toTypedArray()) + flags(16, *SPARK_WARNINGS.map { "${it}_WARNING" }.toTypedArray()) +
        flags(24, *SPARK_FAULTS.map { "${it}_STICKY_FAULT" }.toTypedArray()) +
        flags(40, *SPARK_WARNINGS.map { "${it}_STICKY_WARNING" }.toTypedArray()) + flags(48, "IS_FOLLOWER"),
    2 to floats("PRIMARY_ENCODER_VELOCITY", "PRIMARY_ENCODER_POSITION"),
    3 to listOf(
        RevSignal("ANALOG_VOLTAGE", 0, 10, "V", 0.0048973607038123),
        RevSignal("ANALOG_VELOCITY", 10, 22, scale = 0.007812026887906498, isSigned = true),
        RevSignal("ANALOG_POSITION", 32, 32, isFloat = true),
    ),
    4 to floats("EXTERNAL_OR_ALT_ENCODER_VELOCITY", "EXTERNAL_OR_ALT_ENCODER_POSITION"),
    5 to floats("DUTY_CYCLE_ENCODER_VELOCITY", "DUTY_CYCLE_ENCODER_POSITION"),
    6 to listOf(
        RevSignal("UNADJUSTED_DUTY_CYCLE", 0, 16, scale = 0.00001541161211566339),
        RevSignal("DUTY_CYCLE_PERIOD", 16, 16, "us"),
    ) + flags(32, "DUTY_CYCLE_NO_SIGNAL"),
    7 to floats("I_ACCUMULATION"),
    8 to floats("SETPOINT") + flags(32, "IS_AT_SETPOINT") + RevSignal("SELECTED_PID_SLOT", 33, 4),
    9 to floats("MAXMOTION_POSITION_SETPOINT", "MAXMOTION_VELOCITY_SETPOINT"),
)

private val SPARK_FAULTS = listOf("OTHER", "MOTOR_TYPE", "SENSOR", "CAN", "TEMPERATURE", "DRV", "ESC_EEPROM", "FIRMWARE")
private val SPARK_WARNINGS = listOf("BROWNOUT", "OVERCURRENT", "ESC_EEPROM", "EXT_EEPROM", "SENSOR", "STALL", "HAS_RESET", "OTHER")

private fun servoHubFrames(): Map<Int, List<RevSignal>> = mapOf(
    0 to listOf(
        RevSignal("VOLTAGE", 0, 10, "V", 0.025),
        RevSignal("SERVO_VOLTAGE", 10, 10, "V", 0.025),
        RevSignal("DEVICE_CURRENT", 20, 10, "A", 0.02),
    ) + flags(30, "PRIMARY_HEARTBEAT_LOCK", "SYSTEM_ENABLED") + RevSignal("COMMUNICATION_MODE", 32, 3),
    1 to flags(0, *SERVO_HUB_FAULTS) + flags(32, *SERVO_HUB_FAULTS.map { "STICKY_$it" }.toTypedArray()),
    2 to servoChannels(0),
    3 to servoChannels(3),
    4 to List(6) { RevSignal("CHANNEL_${it}_CURRENT", it * 10, 10, "A", 0.01) },
)

private val SERVO_HUB_FAULTS = arrayOf(
    "REGULATOR_PGOOD_FAULT", "BROWNOUT", "CAN_WARNING", "CAN_BUS_OFF", "HARDWARE_FAULT", "FIRMWARE_FAULT", "HAS_RESET",
    *Array(6) { "CHANNEL_${it}_OVERCURRENT" }, "LOW_BATTERY_FAULT",
)

private fun servoChannels(first: Int): List<RevSignal> = List(3) { RevSignal("CHANNEL_${first + it}_PULSE_WIDTH", it * 16, 16, "us") } +
    flags(48, *Array(3) { "CHANNEL_${first + it}_ENABLED" }) + flags(51, *Array(3) { "CHANNEL_${first + it}_OUT_OF_RANGE" })

private fun encoderFrames(): Map<Int, List<RevSignal>> = mapOf(
    0 to listOf(RevSignal("DEVICE_MODEL", 0, 8)),
    1 to flags(0, *ENCODER_FAULTS) + flags(8, *ENCODER_FAULTS.map { "STICKY_$it" }.toTypedArray()),
    2 to listOf(RevSignal("RAWANGLE", 0, 32, "rot", isFloat = true), RevSignal("ANGLE", 32, 32, "rot", isFloat = true)),
    3 to listOf(RevSignal("TIMESTAMP", 0, 32, "ms"), RevSignal("POSITION", 32, 32, "rot", isFloat = true)),
    4 to listOf(RevSignal("TIMESTAMP", 0, 32, "ms"), RevSignal("VELOCITY", 32, 32, "rpm", isFloat = true)),
)

private val ENCODER_FAULTS = arrayOf("UNEXPECTED", "HAS_RESET", "CAN_TX", "CAN_RX", "EEPROM")

private fun flags(start: Int, vararg names: String) = names.mapIndexed { i, name -> RevSignal(name, start + i, 1) }

private fun floats(vararg names: String) = names.mapIndexed { i, name -> RevSignal(name, i * 32, 32, isFloat = true) }

/**
 * REV's devices by their types on the CAN bus. The bit positions of their values follow REV's public descriptions of the frames (`spark`,
 * `servo_hub` and `encoder`, of its converter from `.revlog` to WPILOG, 2026).
 */
internal val REV_DEVICES: Map<Int, RevDevice> = mapOf(
    2 to RevDevice("Spark", sparkFrames()) { bytes, at ->
        "${unsigned(bytes, at)}.${unsigned(bytes, at + 1)}.${(unsigned(bytes, at + 2) shl 8) + unsigned(bytes, at + 3)}"
    },
    12 to RevDevice("ServoHub", servoHubFrames()) { bytes, at ->
        "${unsigned(bytes, at + 2)}.${unsigned(bytes, at + 1)}.${unsigned(bytes, at)}"
    },
    7 to RevDevice("Encoder", encoderFrames()) { bytes, at ->
        "${unsigned(bytes, at + 5)}.${unsigned(bytes, at + 4)}.${unsigned(bytes, at + 3)}"
    },
)
