package badlog.viewer.shown.swerve

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.viewer.text.fixedText
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The distance of a module from its target over a part of x.
 *
 * @property label the displayed name of the module.
 * @property angle the error of the angle; null if the module did not drive, or its angle is unknown.
 * @property speed the error of the speed; null if the module did not drive, or its speed is unknown.
 */
class ModuleError internal constructor(val label: String, val angle: ErrorSize?, val speed: ErrorSize?, internal val target: Turning)

/** The unit of an error, with a readable number of decimals. */
internal enum class ErrorUnit(private val text: String, private val decimals: Int) {
    DEGREES("°", 1),
    SPEED(" m/s", 2),
    ;

    fun textOf(value: Double): String = fixedText(value, decimals) + text

    /** Returns the range from [least] to [most] as text, with the unit once. */
    fun textOf(least: Double, most: Double): String {
        val number = fixedText(least, decimals)
        return if (number == fixedText(most, decimals)) textOf(most) else "$number to ${textOf(most)}"
    }
}

/**
 * The size of an error over a part of x.
 *
 * @property rms the root mean square by time.
 * @property mean the mean by time.
 * @property meanSize the mean of the absolute values by time.
 * @property largest the error that is farthest from 0.
 * @property largestAt the x at which the largest error begins.
 */
class ErrorSize private constructor(
    val rms: Double,
    internal val mean: Double,
    internal val meanSize: Double,
    val largest: Double,
    val largestAt: Double,
    private val unit: ErrorUnit,
) {
    /** The displayed [rms]: `1.2° RMS`. */
    val rmsText: String get() = "${unit.textOf(rms)} RMS"

    /** The displayed [largest]: `largest -9.8°`. */
    val largestText: String get() = "largest ${unit.textOf(largest)}"

    /** Returns the hint for a click on the largest error; [place] is its displayed place. */
    fun goText(place: String): String = "Go to the largest error, at $place"

    internal companion object {
        private const val BEYOND_ROUNDING = 1 + 1e-9

        /** Returns the size of [error] within [part]; null if it has no values there. Each value holds until the next one. */
        fun of(error: Series, part: Span, unit: ErrorUnit): ErrorSize? {
            var time = 0.0
            var squares = 0.0
            var sum = 0.0
            var sizes = 0.0
            var largest = 0.0
            var largestAt = Double.NaN
            var i = maxOf(0, error.firstAfter(part.from) - 1)
            while (i + 1 < error.size && error.x[i] < part.to) {
                val from = maxOf(error.x[i], part.from)
                val width = minOf(error.x[i + 1], part.to) - from
                val value = error.y[i]
                if (width > 0 && value.isFinite()) {
                    time += width
                    squares += width * value * value
                    sum += width * value
                    sizes += width * abs(value)
                    if (largestAt.isNaN() || abs(value) > abs(largest) * BEYOND_ROUNDING) {
                        largest = value
                        largestAt = from
                    }
                }
                i++
            }
            return if (time > 0) ErrorSize(sqrt(squares / time), sum / time, sizes / time, largest, largestAt, unit) else null
        }
    }
}
