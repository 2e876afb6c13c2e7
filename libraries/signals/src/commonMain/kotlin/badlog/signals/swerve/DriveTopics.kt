package badlog.signals.swerve

import badlog.core.recording.Topic

/**
 * The modules of a drive: their measured values and their targets.
 *
 * @property measured the first modules that are measured.
 * @property target the targets that all measured modules have, optimized ones if possible; null if there are none.
 * @property withoutTarget the labels of the modules that lack a target in the most complete targets.
 */
class DriveTopics private constructor(val measured: SwerveModules, val target: SwerveModules?, val withoutTarget: List<String>) {
    companion object {
        /** Returns the drive among [topics]; null for none. It looks at names only. */
        fun of(topics: List<Topic>): DriveTopics? {
            val all = swerveModulesOf(topics)
            val measured = all.firstOrNull { !it.isTarget } ?: return null
            val targets = all.filter { it.isTarget }
            val target = targets.filter { it.labels.containsAll(measured.labels) }.maxByOrNull { isOptimized(it.speeds[0]) }
            val lacking = targets.map { measured.labels - it.labels.toSet() }.minByOrNull { it.size } ?: measured.labels
            return DriveTopics(measured, target, lacking)
        }
    }
}
