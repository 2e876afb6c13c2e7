package badlog.signals.swerve

import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf

/**
 * Three to six modules of a swerve drive with speeds and angles in structs, `SwerveModuleState` and `SwerveModuleVelocity`. They are an array of
 * structs, or one topic each in a folder. They are known by their fields, whatever the names of the topics.
 *
 * @property name the name of the array or folder.
 * @property elements the name of each struct.
 * @property speeds the topic of the speed of each.
 */
internal class ModuleList(val name: String, val elements: List<String>, val speeds: List<String>) {
    /** The topic of the angle of each. */
    val angles: List<String> get() = elements.map { it + ANGLE }

    /** Whether these are targets rather than measured values. */
    val isTarget: Boolean = wordsOf(name).any { it in TARGET_WORDS }

    /** Whether it is a whole array, in order. */
    val isArray: Boolean get() = elements.indices.all { elements[it] == "$name[$it]" }
}

/** Returns the lists of modules among the topics called [names], in the order of these. Each has its modules by name. */
internal fun moduleListsOf(names: Collection<String>): List<ModuleList> {
    val known = names.toHashSet()
    val elements = names.filter { it.endsWith(ANGLE) }.map { it.removeSuffix(ANGLE) }
        .filter { element -> SPEEDS.any { element + it in known } }
    val lists = elements.groupBy { it.substringBeforeLast(if (it.endsWith(']')) '[' else '/') }
    return lists.filterValues { it.size in MIN_MODULES..MAX_MODULES }.map { (name, unordered) ->
        val modules = unordered.sorted()
        ModuleList(name, modules, modules.map { element -> element + SPEEDS.first { element + it in known } })
    }
}

/** Returns the name for people of a module that the log only numbers. */
internal fun numberedLabel(module: Int): String = "Module $module"

/** Returns whether [name] is of optimized targets: each module is turned in the direction that needs the smaller turn. */
internal fun isOptimized(name: String): Boolean = "optimized" in name.lowercase()

internal const val MIN_MODULES = 3
internal const val MAX_MODULES = 6
private const val ANGLE = "/angle/value"
private val SPEEDS = listOf("/speed", "/velocity")
