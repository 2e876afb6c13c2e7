package badlog.viewer.shown.swerve

import badlog.core.recording.Topic
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf

/**
 * The three to six modules of a swerve drive, by the names of the topics with the speed and direction of each wheel.
 *
 * @property labels their names for people.
 * @property places where they are.
 * @property isTarget whether these are targets rather than measured values.
 */
class SwerveModules internal constructor(
    internal val labels: List<String>,
    internal val places: List<ModulePlace>,
    internal val speeds: List<String>,
    internal val angles: List<String>,
    val isTarget: Boolean,
    internal val meters: Double = 1.0,
    internal val radians: Double = 1.0,
)

/**
 * Returns the modules in [topics], front before back, left before right: arrays of structs such as `SwerveModuleState` and
 * `SwerveModuleVelocity`, which are known by their fields; if there are none, separate topics for each module, see [separateModulesOf].
 */
fun swerveModulesOf(topics: List<Topic>): List<SwerveModules> = modulesInArrays(topics).ifEmpty { separateModulesOf(topics) }

private fun modulesInArrays(topics: List<Topic>): List<SwerveModules> {
    val names = topics.filter { it.samples.isNotEmpty() }.mapTo(LinkedHashSet()) { it.name }
    return names.mapNotNull { name ->
        val field = SPEEDS.firstOrNull { name.endsWith("[0]$it") } ?: return@mapNotNull null
        val base = name.removeSuffix("[0]$field")
        fun angle(module: Int) = "$base[$module]/angle/value"
        val count = (0..MOST_MODULES).takeWhile { "$base[$it]$field" in names && angle(it) in names }.size
        if (count !in LEAST_MODULES..MOST_MODULES) return@mapNotNull null
        val modules = 0 until count
        SwerveModules(
            modules.map(::numberedLabel),
            modulePlacesOf(count),
            modules.map { "$base[$it]$field" },
            modules.map(::angle),
            isTarget = wordsOf(base).any { it in TARGET_WORDS },
        )
    }
}

/** Returns the name for people of a module that the log only numbers: the same as in findings. */
internal fun numberedLabel(module: Int): String = "Module $module"

internal const val LEAST_MODULES = 3
internal const val MOST_MODULES = 6
private val SPEEDS = listOf("/speed", "/velocity")
