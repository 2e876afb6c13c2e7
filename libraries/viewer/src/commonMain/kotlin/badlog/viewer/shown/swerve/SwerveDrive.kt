package badlog.viewer.shown.swerve

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsEnabled

/**
 * The swerve drive of a log.
 *
 * @property modules its three to six modules, in the order of the log, or front before back, left before right.
 */
class SwerveDrive private constructor(private val view: LogView, val modules: List<DriveModule>) {
    /** Whether the log has what the modules should do. */
    val hasTargets: Boolean get() = modules.all { it.target != null }

    /** The highest speed of a wheel, actual or target, in m/s; 0 if none turned. */
    val fastest: Double by lazy { modules.maxOf { maxOf(it.actual.fastest, it.target?.fastest ?: 0.0) } }

    /** How well the modules followed their targets; null without targets, or if x goes backwards. The first use reads all samples. */
    val errors: DriveErrors? by lazy {
        val lines = modules.flatMap { listOfNotNull(it.actual, it.target) }
        val enabled = if (view.knowsEnabled) view.enabledSpans().map { it.span } else null
        if (hasTargets && lines.all { it.isOrdered }) DriveErrors.of(modules, enabled) else null
    }

    companion object {
        /** The sentence for a log without modules. */
        const val NONE: String = "This log has no swerve modules that are known by their names: structs, or speed and angle of each."

        /** The sentence for modules without [errors]. */
        const val NO_TARGETS: String = "This log has no targets of its modules, so their errors are not known."

        /** What the arrows mean. */
        const val ARROWS: String = "Solid: actual. Outline: target."

        /**
         * Returns the drive of [view]: the first modules that are measured, with targets of all of them, optimized ones if there are any. Null
         * for none. It looks at names only.
         */
        fun of(view: LogView): SwerveDrive? {
            val topics = view.recording.topics.associateBy { it.name }
            fun line(name: String): GraphSeries = view.seriesOf(topics.getValue(name))
            fun wheels(modules: SwerveModules) = modules.speeds.zip(modules.angles) { speed, angle ->
                WheelLines(line(speed), line(angle), modules.meters, modules.radians)
            }
            val all = swerveModulesOf(view.recording.topics)
            val actual = all.firstOrNull { !it.isTarget } ?: return null
            val targets = all.filter { it.isTarget && it.labels.containsAll(actual.labels) }
            val target = targets.maxByOrNull { "optimized" in it.speeds[0].lowercase() }
            val wanted = target?.let { it.labels.zip(wheels(it)).toMap() }.orEmpty()
            val modules = wheels(actual).mapIndexed { i, wheel ->
                DriveModule(actual.labels[i], actual.places[i], wheel, wanted[actual.labels[i]])
            }
            return SwerveDrive(view, modules)
        }
    }
}
