package badlog.signals.swerve

import badlog.core.recording.Topic

/**
 * The three to six modules of a swerve drive, with the topics of each wheel's speed and direction.
 *
 * @property labels their names for people.
 * @property corners the corner of each: 0 for the front left one, then front right, back left, back right; null if the log numbers them.
 * @property speeds the topics of their speeds.
 * @property angles the topics of their angles, counterclockwise from straight ahead.
 * @property isTarget whether these are targets rather than measured values.
 * @property meters the factor from the speeds to m/s.
 * @property radians the factor from the angles to rad.
 */
class SwerveModules internal constructor(
    val labels: List<String>,
    val corners: List<Int>?,
    val speeds: List<String>,
    val angles: List<String>,
    val isTarget: Boolean,
    val meters: Double = 1.0,
    val radians: Double = 1.0,
)

/**
 * Returns the modules in [topics], front before back, left before right. They are arrays of structs such as `SwerveModuleState` and
 * `SwerveModuleVelocity`, which are known by their fields; otherwise separate topics for each module, see [separateModulesOf].
 */
fun swerveModulesOf(topics: List<Topic>): List<SwerveModules> = modulesInArrays(topics).ifEmpty { separateModulesOf(topics) }

private fun modulesInArrays(topics: List<Topic>): List<SwerveModules> {
    val names = topics.filter { it.samples.isNotEmpty() }.mapTo(LinkedHashSet()) { it.name }
    return moduleListsOf(names).filter { it.isArray }.map { list ->
        SwerveModules(list.elements.indices.map(::numberedLabel), corners = null, list.speeds, list.angles, list.isTarget)
    }
}
