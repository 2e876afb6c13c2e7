package badlog.signals.swerve

import badlog.expression.signals.Signal
import badlog.signals.derived.PartTopic
import badlog.signals.derived.Quantity
import badlog.signals.vocabulary.wordsOf
import kotlin.math.PI

/**
 * The topics of a swerve module, by their full names.
 *
 * @property label its name for people, such as `Module 2` or `Front Left`.
 * @property radians the factor from its angles to rad.
 */
class ModuleTopics internal constructor(
    val label: String,
    val speed: String,
    val angle: String,
    val targetSpeed: String?,
    val targetAngle: String?,
    val radians: Double,
) {
    val topics: List<String> get() = listOfNotNull(angle, targetAngle, speed, targetSpeed)
}

/**
 * Returns the topics of the drive's modules, in order; empty if [names] have none. They are [lists of modules][ModuleList], or speed and
 * angle of four corners among [parts], with units that may be known by their names alone.
 */
internal fun moduleTopicsOf(names: List<Signal>, parts: List<PartTopic>): List<ModuleTopics> =
    listedModules(names).ifEmpty { namedModules(parts) }

private fun listedModules(names: List<Signal>): List<ModuleTopics> {
    val lists = moduleListsOf(names.mapTo(HashSet()) { it.name }.sorted())
    val measured = lists.firstOrNull { !it.isTarget } ?: return emptyList()
    val target = lists.filter { it.isTarget && it.elements.size == measured.elements.size }.maxByOrNull { isOptimized(it.name) }
    return measured.elements.indices.map { i ->
        val (speed, angle) = measured.speeds[i] to measured.angles[i]
        ModuleTopics(numberedLabel(i), speed, angle, target?.speeds?.get(i), target?.angles?.get(i), radians = 1.0)
    }
}

private fun namedModules(parts: List<PartTopic>): List<ModuleTopics> {
    val ofCorners = parts.filter { cornerOf(it.part) != null }
    val byModule = ofCorners.groupBy { topic -> topic.part.dropLastWhile { it in DRIVE_WORDS || it in STEER_WORDS } }
    val found = byModule.mapNotNull { (module, topics) -> moduleOf(module, topics) }
    return if (found.size == 4) found else emptyList()
}

/** Returns the module [part] that [topics] are of; null without its speed and its angle. */
private fun moduleOf(part: List<String>, topics: List<PartTopic>): ModuleTopics? {
    fun of(quantity: Quantity, isTarget: Boolean, others: Set<String>) =
        topics.filter { topic -> topic.isTarget == isTarget && topic.quantity == quantity && topic.part.last() !in others }
    fun speeds(isTarget: Boolean) = of(Quantity.VELOCITY, isTarget, STEER_WORDS)
    fun angles(isTarget: Boolean) = of(Quantity.POSITION, isTarget, DRIVE_WORDS)
    val speed = speeds(isTarget = false).firstOrNull() ?: return null
    val angle = angles(isTarget = false).find { "angle" in wordsOf(it.signal.name) } ?: return null
    // “Front Left Setpoint” is the setpoint of the speed if “Front Left Angle Setpoint” is beside it.
    val steered = of(Quantity.NONE, isTarget = true, DRIVE_WORDS).filter { topic ->
        // A command may be the motor's output.
        topic.part.last() in STEER_WORDS && wordsOf(topic.signal.name).none { it in COMMANDED }
    }
    val targetSpeed = speeds(isTarget = true).firstOrNull() ?: of(Quantity.NONE, isTarget = true, STEER_WORDS).firstOrNull()
    return ModuleTopics(
        labelOfCorner(cornerOf(part) ?: return null),
        speed.signal.name,
        angle.signal.name,
        targetSpeed?.signal?.name,
        (angles(isTarget = true) + steered).firstOrNull()?.signal?.name,
        if (angle.unit == "rad") 1.0 else PI / 180,
    )
}

/** The words in names that mean the steering motor of a module. */
internal val STEER_WORDS = setOf("turn", "steer", "steering", "azimuth", "angle")
private val DRIVE_WORDS = setOf("drive", "driving")
private val COMMANDED = setOf("cmd", "command", "commanded", "demand")
