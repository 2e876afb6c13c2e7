package badlog.viewer.shown.swerve

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.round

/**
 * How far the modules of a drive are from their targets over time: only while the robot is enabled, if that is known, and the module should
 * drive, see [WHEN].
 *
 * @property modules the lines of each module.
 */
class DriveErrors private constructor(val modules: List<Lines>) {
    /**
     * The errors of the module [label] over x; each holds until the next one, NaN where it should not drive.
     *
     * @property angle the angle minus its target, in degrees, -90 to 90: a module that runs backward instead of turning by half a turn
     *   follows its target.
     * @property speed the speed minus its target, in m/s, with the sign of the way that the module points.
     */
    class Lines internal constructor(val label: String, val angle: Series, val speed: Series)

    /** Returns the sizes of the errors of each module within [part] of x. */
    fun within(part: Span): List<ModuleError> = modules.map {
        ModuleError(it.label, ErrorSize.of(it.angle, part, ErrorUnit.DEGREES), ErrorSize.of(it.speed, part, ErrorUnit.SPEED))
    }

    companion object {
        /** When errors count, for people. */
        const val WHEN: String = "Errors count while the robot is enabled and the target of a module is 0.3 m/s or more."

        /** In m/s: of a slower module, the direction says little. The same as for findings. */
        private const val DRIVING = 0.3

        /** Returns those of [modules], whose targets are known; [enabled] is null if the log does not show when the robot was enabled. */
        internal fun of(modules: List<DriveModule>, enabled: List<Span>?): DriveErrors =
            DriveErrors(modules.map { module -> linesOf(module.label, module.actual, checkNotNull(module.target), enabled) })

        private fun linesOf(label: String, actual: WheelLines, target: WheelLines, enabled: List<Span>?): Lines {
            val series = listOf(actual.angle, actual.speed, target.angle, target.speed).map { it.data }
            // A log of changes has no sample where the robot is disabled, or an angle stays behind its target.
            val edges = enabled.orEmpty().flatMap { listOf(it.from, it.to) }.toDoubleArray()
            val x = orderedUnion(series.map { it.x } + edges)
            val at = IntArray(series.size) { -1 }
            var span = 0
            val angle = DoubleArray(x.size)
            val speed = DoubleArray(x.size)
            for (i in x.indices) {
                for (k in at.indices) while (at[k] + 1 < series[k].size && series[k].x[at[k] + 1] <= x[i]) at[k]++
                while (enabled != null && span < enabled.size && enabled[span].to <= x[i]) span++
                val isEnabled = enabled == null || (span < enabled.size && enabled[span].from <= x[i])
                val wanted = target.speedOf(at[3])
                val off = if (isEnabled && abs(wanted) >= DRIVING) actual.angleOf(at[0]) - target.angleOf(at[2]) else Double.NaN
                val halfTurns = round(off / PI)
                val isBackward = abs(halfTurns % 2) == 1.0
                val degrees = (off - PI * halfTurns) * DEGREES / PI
                angle[i] = if (degrees.isFinite()) degrees else Double.NaN
                val along = if (isBackward) -actual.speedOf(at[1]) else actual.speedOf(at[1])
                speed[i] = if (degrees.isFinite()) along - wanted else Double.NaN
            }
            return Lines(label, Series(x, angle), Series(x, speed))
        }

        /** Returns all numbers of [lists] once, ascending. */
        private fun orderedUnion(lists: List<DoubleArray>): DoubleArray {
            val all = DoubleArray(lists.sumOf { it.size })
            var size = 0
            for (list in lists) {
                list.copyInto(all, size)
                size += list.size
            }
            all.sort()
            var count = 0
            for (value in all) if (count == 0 || value != all[count - 1]) all[count++] = value
            return all.copyOf(count)
        }

        private const val DEGREES = 180.0
    }
}
