package badlog.signals.derived

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf

/** The quantity that a topic of a robot's part measures. */
enum class Quantity { POSITION, VELOCITY, CURRENT, SUPPLY_CURRENT, VOLTAGE, OUTPUT, SWITCH, NONE }

/**
 * A topic of a part of a robot: `Elevator/Target Height` is a target position of the elevator, in m.
 *
 * @property part the words of its name that remain, without the words for the quantity, the target, and the program that logged it.
 * @property quantity the measured quantity; NONE if its name does not show it.
 * @property unit its unit, by the log or by its name; empty if unknown.
 * @property isTarget whether it is the program's target rather than a sensor's value.
 * @property isAbsolute whether it is from a sensor other than the motor's own.
 * @property isMotor whether its name says that it is about the motor, not the moved part.
 */
class PartTopic internal constructor(
    val signal: Signal,
    val part: List<String>,
    val quantity: Quantity,
    val unit: String,
    val isTarget: Boolean,
    val isAbsolute: Boolean,
    val isMotor: Boolean,
) {
    /** The name of the part for people. */
    val label: String get() = part.joinToString(" ") { word -> word.replaceFirstChar { it.uppercase() } }
}

/** Returns the topics of parts among [topics], with the units of [vocabulary]; topics without a part are left out. */
fun partTopicsOf(topics: List<Signal>, vocabulary: SignalVocabulary): List<PartTopic> = topics.mapNotNull { partTopicOf(it, vocabulary) }

private fun partTopicOf(signal: Signal, vocabulary: SignalVocabulary): PartTopic? {
    if (signal.kind != SignalKind.NUMBER && signal.kind != SignalKind.CONDITION) return null
    val isRotation = signal.name.endsWith(ROTATION) && !signal.name.endsWith("/angle$ROTATION")
    val name = if (isRotation) signal.name.removeSuffix(ROTATION) else signal.name
    if (name.endsWith(']') || STRUCT_FIELDS.any { name.endsWith(it) }) return null
    val named = vocabulary.unitIn(name)
    val ending = named?.let { unit -> name.length - name.trimEnd(')').length + unit.ending.length } ?: 0
    val words = wordsOf(name.dropLast(ending))
    // A part of a rotation.
    if ("q" in words) return null
    val unitOfLog = signal.unit.takeIf { it.isNotEmpty() && it != "ul" }
    val unit = unitOfLog ?: if (isRotation) "rad" else named?.unit.orEmpty()
    val quantity = quantityOf(words, unit, signal.kind)
    val part = words.filter { it !in ROOTS && it !in TARGET_WORDS && it !in QUANTITY_WORDS && it !in QUALIFIERS }
    if (part.isEmpty()) return null
    return PartTopic(
        signal,
        part,
        quantity,
        unit,
        isTarget = words.any { it in TARGET_WORDS },
        isAbsolute = words.any { it in ABSOLUTE },
        isMotor = words.any { it in MOTOR },
    )
}

private fun quantityOf(words: List<String>, unit: String, kind: SignalKind): Quantity {
    if (kind == SignalKind.CONDITION) return if (words.any { it in SWITCHES }) Quantity.SWITCH else Quantity.NONE
    val own = words.lastOrNull { it in QUANTITY_WORDS }
    // A bag writes truth values as 1 and 0.
    val isSwitch = "switch" in words && unit.isEmpty() && words.none { it in OTHER && it != "limit" }
    return when {
        isSwitch -> Quantity.SWITCH
        words.any { it in OTHER } -> Quantity.NONE
        unit in AMPERES || own in CURRENTS -> if ("supply" in words || "input" in words) Quantity.SUPPLY_CURRENT else Quantity.CURRENT
        unit == "V" || own in VOLTAGES -> Quantity.VOLTAGE
        unit in SPEEDS || own in VELOCITIES -> Quantity.VELOCITY
        unit in PLACES || own in POSITIONS -> Quantity.POSITION
        own in OUTPUTS -> Quantity.OUTPUT
        else -> Quantity.NONE
    }
}

private const val ROTATION = "/value"
private val STRUCT_FIELDS = listOf("/x", "/y", "/z", "/w", "/angle/value", "/speed", "/omega", "/vx", "/vy", "/length", "/type", "/schema")

private val POSITIONS = setOf("position", "pos", "angle", "height", "extension", "rotation", "rotations", "yaw")
private val VELOCITIES = setOf("velocity", "vel", "speed", "rpm", "rps")
private val CURRENTS = setOf("current", "amps", "amperes")
private val VOLTAGES = setOf("volts", "voltage")
private val OUTPUTS = setOf("output", "percent", "duty", "cycle")
private val SWITCHES = setOf("limit", "switch")
private val QUANTITY_WORDS = POSITIONS + VELOCITIES + CURRENTS + VOLTAGES + OUTPUTS + SWITCHES

private val ABSOLUTE = setOf("absolute", "abs", "encoder", "enc", "cancoder", "throughbore")
private val MOTOR = setOf("motor", "rotor")
private val QUALIFIERS = ABSOLUTE + MOTOR + setOf(
    "applied", "supply", "stator", "input", "measured", "measurement", "actual", "bottom", "top", "lower", "upper", "forward",
    "reverse", "is", "pressed",
)

/** Words of topics that are not a sensor of a part, whatever else their names say. */
private val OTHER = setOf(
    "temp", "temperature", "celsius", "fault", "faults", "gain", "limit", "max", "min", "tolerance", "offset", "error",
    "torque", "ks", "kv", "kp", "kd", "ki", "time", "count",
)

/** Words for the program or library that logged a topic. */
private val ROOTS = setOf(
    "nt", "smart", "dashboard", "smartdashboard", "shuffleboard", "telemetry", "real", "outputs", "realoutputs", "replay",
    "advantage", "kit", "system", "live", "window", "inputs", "m", "robot",
)
private val AMPERES = setOf("A", "amps")
private val SPEEDS = setOf("rpm", "RPM", "rad/s", "rot/s", "rps", "deg/s", "m/s")
private val PLACES = setOf("m", "rad", "deg", "rot", "in", "cm", "mm", "°", "degrees", "inches", "meters")
