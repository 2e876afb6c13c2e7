package badlog.samples.generated.log

import badlog.samples.generated.fault.Signal

/** The type of a topic's values, with its name in a WPILOG. */
internal sealed interface ValueType {
    val name: String

    data object Number : ValueType {
        override val name get() = "double"
    }

    data object Whole : ValueType {
        override val name get() = "int64"
    }

    data object Truth : ValueType {
        override val name get() = "boolean"
    }

    data object Text : ValueType {
        override val name get() = "string"
    }

    data object Texts : ValueType {
        override val name get() = "string[]"
    }

    data object Numbers : ValueType {
        override val name get() = "double[]"
    }

    data object Floats : ValueType {
        override val name get() = "float[]"
    }

    /** A message of the Driver Station of 2027. */
    data class Encoded(val message: Message) : ValueType {
        override val name get() = "proto:${Message.PACKAGE}.${message.typeName}"
    }

    /** One or more structs with only doubles as fields. */
    data class Structs(val struct: Struct, val isArray: Boolean) : ValueType {
        override val name get() = "struct:${struct.typeName}" + if (isArray) "[]" else ""
    }
}

/** Structs of WPILib that consist of doubles, and one of 64 bits, with their schemas. */
internal enum class Struct(val typeName: String, val schema: String, val parts: List<String> = emptyList()) {
    ROTATION_2D("Rotation2d", "double value"),
    TRANSLATION_2D("Translation2d", "double x;double y"),
    POSE_2D("Pose2d", "Translation2d translation;Rotation2d rotation", listOf("Translation2d", "Rotation2d")),
    TRANSLATION_3D("Translation3d", "double x;double y;double z"),
    QUATERNION("Quaternion", "double w;double x;double y;double z"),
    ROTATION_3D("Rotation3d", "Quaternion q", listOf("Quaternion")),
    POSE_3D("Pose3d", "Translation3d translation;Rotation3d rotation", listOf("Translation3d", "Rotation3d")),
    MODULE_STATE("SwerveModuleState", "double speed;Rotation2d angle", listOf("Rotation2d")),
    CHASSIS_SPEEDS("ChassisSpeeds", "double vx;double vy;double omega"),
    CONTROL_WORD(
        "ControlWord",
        "uint64 opModeHash:56;enum{unknown=0,autonomous=1,teleoperated=2,utility=3}uint64 robotMode:2;" +
            "bool enabled:1;bool eStop:1;bool fmsAttached:1;bool dsAttached:1;",
    ),
    ;

    /** Returns this struct and all structs of its fields. */
    fun withParts(): List<Struct> = parts.flatMap { part -> entries.first { it.typeName == part }.withParts() } + this
}

/**
 * A topic of a generated log.
 *
 * @property signal the measured quantity; null if it is not one of these.
 * @property part the part of the robot that it describes, such as `Elevator`; empty for the whole robot.
 * @property everyLoops the number of loops between two samples; 0 if a sample is taken with each status frame.
 * @property read returns its current value: a Double, Long, Boolean, String, DoubleArray, ByteArray or list of strings; null for no sample.
 */
internal class LoggedTopic(
    val name: String,
    val type: ValueType,
    val unit: String,
    val attributes: List<String>,
    val signal: Signal?,
    val part: String,
    val everyLoops: Int,
    val read: () -> Any?,
)

/** Collects the topics of a log. */
internal class TopicList {
    val topics = ArrayList<LoggedTopic>()

    fun add(
        name: String,
        type: ValueType,
        signal: Signal?,
        part: String = "",
        unit: String = "ul",
        every: Int = 1,
        attributes: List<String> = emptyList(),
        read: () -> Any?,
    ) {
        topics += LoggedTopic(name, type, unit, attributes, signal, part, every, read)
    }

    fun number(
        name: String,
        signal: Signal?,
        part: String = "",
        unit: String = "ul",
        every: Int = 1,
        attributes: List<String> = emptyList(),
        read: () -> Double?,
    ) = add(name, ValueType.Number, signal, part, unit, every, attributes, read)

    fun truth(name: String, signal: Signal?, part: String = "", every: Int = 1, read: () -> Boolean) =
        add(name, ValueType.Truth, signal, part, every = every, read = read)

    fun structs(
        name: String,
        struct: Struct,
        signal: Signal?,
        part: String = "",
        isArray: Boolean = false,
        every: Int = 1,
        read: () -> DoubleArray?,
    ) = add(name, ValueType.Structs(struct, isArray), signal, part, every = every, read = read)
}
