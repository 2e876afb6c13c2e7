package badlog.signals.derived

import badlog.core.analysis.Series
import badlog.expression.signals.Signal
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.round

/**
 * The topics of a swerve module, by their full names.
 *
 * @property label its name for people, such as `Module 2` or `Front Left`.
 * @property radians what its angles are multiplied by to get rad.
 */
class SwerveModule internal constructor(
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
 * Returns the modules of a swerve drive, in order, empty if [names] have none: structs `SwerveModuleState` and `SwerveModuleVelocity`,
 * which are known by their fields whatever the topic is called, or speed and angle among [parts].
 */
fun swerveModulesOf(names: List<Signal>, parts: List<PartTopic>): List<SwerveModule> = structModules(names).ifEmpty { namedModules(parts) }

private fun structModules(names: List<Signal>): List<SwerveModule> {
    val known = names.mapTo(HashSet()) { it.name }
    val lists = LinkedHashMap<String, MutableList<String>>()
    for (name in known.sorted()) {
        if (!name.endsWith(STRUCT_ANGLE)) continue
        val element = name.removeSuffix(STRUCT_ANGLE)
        if (SPEED_FIELDS.none { element + it in known }) continue
        val list = element.substringBeforeLast(if (element.endsWith(']')) '[' else '/')
        lists.getOrPut(list) { ArrayList() } += element
    }
    val whole = lists.filter { it.value.size in 3..6 }
    fun isTarget(list: String) = wordsOf(list).any { it in TARGET_WORDS }
    val measured = whole.filter { !isTarget(it.key) }.entries.firstOrNull() ?: return emptyList()
    val targets = whole.filter { isTarget(it.key) && it.value.size == measured.value.size }.entries
    val target = targets.maxByOrNull { "optimized" in it.key.lowercase() }
    fun speed(element: String) = element + SPEED_FIELDS.first { element + it in known }
    return measured.value.mapIndexed { index, element ->
        val wanted = target?.value?.get(index)
        SwerveModule("Module $index", speed(element), element + STRUCT_ANGLE, wanted?.let(::speed), wanted?.plus(STRUCT_ANGLE), 1.0)
    }
}

private fun namedModules(parts: List<PartTopic>): List<SwerveModule> {
    fun of(part: List<String>, quantity: Quantity, isTarget: Boolean) = parts.find { topic ->
        // “Front Left Setpoint” is that of the speed, if “Front Left Angle Setpoint” is beside it.
        val isOfSpeed = isTarget && quantity == Quantity.VELOCITY && topic.quantity == Quantity.NONE
        topic.part == part && topic.isTarget == isTarget && (topic.quantity == quantity || isOfSpeed)
    }
    val corners = parts.map { it.part }.distinct().filter { part -> part.count { it in CORNERS } == 2 }
    val found = corners.mapNotNull { part ->
        val speed = of(part, Quantity.VELOCITY, isTarget = false) ?: return@mapNotNull null
        val angle = of(part, Quantity.POSITION, isTarget = false)?.takeIf { "angle" in wordsOf(it.signal.name) } ?: return@mapNotNull null
        SwerveModule(
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

/**
 * Returns by how much the angle of module [at] of a drive is off its target at [times], in degrees, beyond what the worst of the others
 * is at that moment. A module that runs backward instead of turning by half a turn follows its target. NaN while the module should stand,
 * or while nothing is enabled.
 */
fun moduleAngleError(
    at: Int,
    times: DoubleArray,
    angles: List<DoubleArray>,
    targets: List<DoubleArray>,
    speeds: List<DoubleArray>,
    isEnabled: BooleanArray,
): Series {
    // While nothing turns, nothing lags; a log of changes has no samples then, either.
    val turning = times.indices.filter { i -> i == 0 || angles.any { it[i] != it[i - 1] } || targets[at][i] != targets[at][i - 1] }
    val steps = DoubleArray(maxOf(0, turning.size - 1)) { times[turning[it + 1]] - times[turning[it]] }
    // An angle that comes seldom is an old one: it followed the target of then.
    val age = quantile(steps, 0.5).let { if (it > SELDOM) 2 * it else 0.0 }
    return Series(
        DoubleArray(turning.size) { times[turning[it]] },
        DoubleArray(turning.size) { k ->
            val i = turning[k]
            if (!isEnabled[i] || !isDriving(speeds[at][i])) {
                Double.NaN
            } else {
                val since = indexBefore(times, i, age)
                val errors = angles.indices.map { module -> (since..i).minOf { halfTurnError(targets[module][it] - angles[module][i]) } }
                errors[at] - errors.filterIndexed { index, _ -> index != at }.max()
            }
        },
    )
}

/** Returns whether the [angles] of modules change more seldom than in each second loop while they turn. */
internal fun isSeldom(times: DoubleArray, angles: List<DoubleArray>): Boolean {
    val turning = (1 until times.size).filter { i -> angles.any { it[i] != it[i - 1] } }
    return quantile(DoubleArray(maxOf(0, turning.size - 1)) { times[turning[it + 1]] - times[turning[it]] }, 0.5) > SELDOM_CHANGES
}

/** Returns the size of an angle of [radians] modulo a half turn, in degrees, 0 to 90. */
internal fun halfTurnError(radians: Double): Double = abs(radians - PI * round(radians / PI)) * 180 / PI

/** Whether a module that is to have [speed], in m/s, has to keep its angle. */
internal fun isDriving(speed: Double): Boolean = abs(speed) >= MOVING

private const val STRUCT_ANGLE = "/angle/value"
private val SPEED_FIELDS = listOf("/speed", "/velocity")
private val CORNERS = setOf("front", "back", "rear", "left", "right")

/** In s. */
private const val SELDOM = 0.05
private const val SELDOM_CHANGES = 0.04

/** In m/s. */
private const val MOVING = 0.3
