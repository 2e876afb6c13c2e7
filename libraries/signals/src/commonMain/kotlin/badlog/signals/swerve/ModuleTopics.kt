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
 * @property radians what its angles are multiplied by to get rad.
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
 * Returns the topics of the modules of the drive on which rules run, in order, empty if [names] have none: [lists of modules][ModuleList],
 * or speed and angle of four corners among [parts], whose units may be known by their names alone.
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
    fun of(part: List<String>, quantity: Quantity, isTarget: Boolean) = parts.find { topic ->
        // “Front Left Setpoint” is that of the speed, if “Front Left Angle Setpoint” is beside it.
        val isOfSpeed = isTarget && quantity == Quantity.VELOCITY && topic.quantity == Quantity.NONE
        topic.part == part && topic.isTarget == isTarget && (topic.quantity == quantity || isOfSpeed)
    }
    val corners = parts.map { it.part }.distinct().filter { part -> part.count { it in CORNERS } == 2 }
    val found = corners.mapNotNull { part ->
        val speed = of(part, Quantity.VELOCITY, isTarget = false) ?: return@mapNotNull null
        val angle = of(part, Quantity.POSITION, isTarget = false)?.takeIf { "angle" in wordsOf(it.signal.name) } ?: return@mapNotNull null
        ModuleTopics(
            part.filter { it in CORNERS }.joinToString(" ") { word -> word.replaceFirstChar { it.uppercase() } },
            speed.signal.name,
            angle.signal.name,
            of(part, Quantity.VELOCITY, isTarget = true)?.signal?.name,
            of(part, Quantity.POSITION, isTarget = true)?.signal?.name,
            if (angle.unit == "rad") 1.0 else PI / 180,
        )
    }
    return if (found.size == 4) found else emptyList()
}

private val CORNERS = setOf("front", "back", "rear", "left", "right")
