package badlog.viewer.shown.swerve

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsEnabled
import badlog.signals.swerve.DriveTopics
import badlog.signals.swerve.SwerveModules

/**
 * The swerve drive of a log.
 *
 * @property modules the three to six modules, in the order of the log, or front before back, left before right.
 */
class SwerveDrive private constructor(private val view: LogView, val modules: List<DriveModule>, private val withoutTarget: List<String>) {
    private val isOrdered get() = modules.all { module -> listOfNotNull(module.actual, module.target).all { it.isOrdered } }

    /** The displayed reason why there are no [errors], as a sentence; null if there are any. */
    val errorsLack: String? by lazy {
        when {
            withoutTarget.size == modules.size -> "This log has no targets of its modules, so their errors are not known."
            withoutTarget.isNotEmpty() -> "This log has no target of ${withoutTarget.joinToString(" and ")}, so the errors are not known."
            !isOrdered -> "${view.xAxis.title} goes backwards in this log, so the errors are not known."
            else -> null
        }
    }

    /** The highest speed of a wheel, actual or target, in m/s, except for the few highest samples. 0 if no wheel turned. */
    val fastest: Double by lazy { modules.maxOf { maxOf(it.actual.fastest, it.target?.fastest ?: 0.0) } }

    /** The errors of the modules relative to their targets; null if unknown, see [errorsLack]. The first use reads all samples. */
    val errors: DriveErrors? by lazy {
        val enabled = if (view.knowsEnabled) view.enabledSpans().map { it.span } else null
        val second = 1 / (Units.secondsIn(view.xAxis.unit) ?: 1.0)
        if (errorsLack == null) DriveErrors.of(modules, enabled, view.xAxis.range?.endInclusive ?: Double.NaN, second) else null
    }

    companion object {
        /** The sentence for a log without modules. */
        const val NONE: String =
            "This log has no swerve modules that badlog recognizes; log SwerveModuleState, or speed and angle of each module."

        /** The displayed meaning of the arrows. */
        const val ARROWS: String = "Solid: actual. Outline: target."

        /**
         * Returns the drive of [view]; null if there is none. It has the first measured modules, with targets if all of them have one;
         * optimized targets are preferred. Only names are examined.
         */
        fun of(view: LogView): SwerveDrive? {
            val topics = view.recording.topics.associateBy { it.name }
            fun line(name: String): GraphSeries = view.seriesOf(topics.getValue(name))
            fun wheels(modules: SwerveModules) = modules.speeds.zip(modules.angles) { speed, angle ->
                WheelLines(line(speed), line(angle), modules.meters, modules.radians)
            }
            val drive = DriveTopics.of(view.recording.topics) ?: return null
            val wanted = drive.target?.let { it.labels.zip(wheels(it)).toMap() }.orEmpty()
            val places = drive.measured.places
            val modules = wheels(drive.measured).mapIndexed { i, wheel ->
                val label = drive.measured.labels[i]
                DriveModule(label, places[i], wheel, wanted[label])
            }
            return SwerveDrive(view, modules, drive.withoutTarget)
        }
    }
}
