package badlog.viewer.shown.swerve

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.round

/**
 * The errors of a drive's modules over time: their distances from their targets, where these count, see [condition].
 *
 * @property modules the lines of each module.
 */
class DriveErrors private constructor(val modules: List<Lines>, private val knowsEnabled: Boolean) {
    /**
     * The errors of the module [label] over x. Each error holds until the next one; it is NaN where it does not count.
     *
     * @property angle the angle minus its target, in degrees, -90 to 90: a module that runs backward instead of turning by half a turn
     *   follows its target.
     * @property speed the speed minus its target, in m/s, with its sign along the direction of the module.
     */
    class Lines internal constructor(val label: String, val angle: Series, val speed: Series, internal val course: TargetCourse)

    /** The displayed condition under which errors count. */
    val condition: String
        get() = if (knowsEnabled) "Errors are counted while the robot is enabled and $WHEN" else "Errors are counted while $WHEN $ANY_TIME"

    /** Returns the sizes of the errors of each module within [part] of x. */
    fun within(part: Span): List<ModuleError> = modules.map {
        ModuleError(
            it.label,
            ErrorSize.of(it.angle, part, ErrorUnit.DEGREES),
            ErrorSize.of(it.speed, part, ErrorUnit.SPEED),
            it.course.within(part),
        )
    }

    companion object {
        private const val WHEN = "the target of a module is 0.3 m/s or more, but not in the 0.2 s after its angle jumps."
        private const val ANY_TIME = "The log does not say when the robot was enabled."

        /** The minimum speed in m/s, the same as for findings: the direction of a slower module means little. */
        private const val DRIVING = 0.3

        /** The jump of a target, in degrees, that no module follows at once. */
        private const val JUMP = 20.0

        /** The time in s that a module may need to reach a target after a jump. */
        private const val AFTER_JUMP = 0.2

        /**
         * Returns the errors of [modules], which all have targets.
         *
         * @param enabled the time when the robot was enabled; null if the log does not show it.
         * @param end the end of the log, until which the last values hold if lines hold their values.
         * @param second one second in the unit of x.
         */
        internal fun of(modules: List<DriveModule>, enabled: List<Span>?, end: Double, second: Double): DriveErrors = DriveErrors(
            modules.map { module -> linesOf(module.label, module.actual, checkNotNull(module.target), enabled, end, second) },
            knowsEnabled = enabled != null,
        )

        private fun linesOf(
            label: String,
            actual: WheelLines,
            target: WheelLines,
            enabled: List<Span>?,
            end: Double,
            second: Double,
        ): Lines {
            val lines = listOf(actual.angle, actual.speed, target.angle, target.speed)
            val series = lines.map { it.data }
            // A log of changes has no sample where the robot is disabled, or where an angle stays behind its target.
            val edges = enabled.orEmpty().flatMap { listOf(it.from, it.to) }.toDoubleArray()
            val last = if (lines.all { it.holds } && end.isFinite()) doubleArrayOf(end) else DoubleArray(0)
            val moments = Moments.of(series.map { it.x } + listOf(edges, last))
            val x = moments.from
            val at = IntArray(series.size) { -1 }
            var span = 0
            val angle = DoubleArray(x.size)
            val speed = DoubleArray(x.size)
            val course = TargetCourse(x, second)
            var before = Double.NaN
            var jumped = Double.NEGATIVE_INFINITY
            for (i in x.indices) {
                val now = moments.until[i]
                for (k in at.indices) while (at[k] + 1 < series[k].size && series[k].x[at[k] + 1] <= now) at[k]++
                while (enabled != null && span < enabled.size && enabled[span].to <= now) span++
                val isEnabled = enabled == null || (span < enabled.size && enabled[span].from <= now)
                val wanted = target.speedOf(at[3])
                val wantedAngle = target.angleOf(at[2])
                val step = degreesOf(wantedAngle - before)
                if (abs(step) > JUMP) jumped = x[i]
                before = wantedAngle
                val counts = isEnabled && wantedAngle.isFinite() && abs(wanted) >= DRIVING && x[i] >= jumped + AFTER_JUMP * second
                course.add(counts, step)
                val off = if (counts) actual.angleOf(at[0]) - wantedAngle else Double.NaN
                angle[i] = degreesOf(off)
                val isBackward = abs(round(off / PI) % 2) == 1.0
                val along = if (isBackward) -actual.speedOf(at[1]) else actual.speedOf(at[1])
                speed[i] = if (angle[i].isNaN()) Double.NaN else along - wanted
            }
            return Lines(label, Series(x, angle), Series(x, speed), course)
        }

        /** Returns an angle of [radians] in degrees without its half turns, -90 to 90; NaN if it is not finite. */
        private fun degreesOf(radians: Double): Double {
            val degrees = (radians - PI * round(radians / PI)) * DEGREES / PI
            return if (degrees.isFinite()) degrees else Double.NaN
        }

        private const val DEGREES = 180.0
    }
}

/**
 * The moments at which something changes. A robot sends the values of a loop one after the other, so that their times differ by fractions
 * of a millisecond. All changes of a loop are one moment; otherwise a new target would be compared with an old measurement.
 *
 * @property from the start of each moment, ascending.
 * @property until the last change of each moment.
 */
internal class Moments private constructor(val from: DoubleArray, val until: DoubleArray) {
    companion object {
        /** The time in s below which two changes are one moment. */
        private const val CLOSE = 0.005

        /** The maximum length of a moment in s, even if changes are always close. */
        private const val LONGEST = 0.01

        /** Returns the moments of the changes in [lists]. Each list is ascending. */
        fun of(lists: List<DoubleArray>): Moments {
            // The fields of a struct share an array, and arrays are only equal to themselves.
            val all = lists.distinct()
            val at = IntArray(all.size)
            val from = DoubleArray(all.sumOf { it.size })
            val until = DoubleArray(from.size)
            var count = 0
            while (true) {
                var next = Double.POSITIVE_INFINITY
                for (k in all.indices) if (at[k] < all[k].size) next = minOf(next, all[k][at[k]])
                if (next == Double.POSITIVE_INFINITY) return Moments(from.copyOf(count), until.copyOf(count))
                for (k in all.indices) while (at[k] < all[k].size && all[k][at[k]] <= next) at[k]++
                if (count == 0 || next - until[count - 1] >= CLOSE || next - from[count - 1] >= LONGEST) from[count++] = next
                until[count - 1] = next
            }
        }
    }
}
