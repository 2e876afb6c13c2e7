package badlog.viewer.shown.swerve

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.viewer.text.fixedText
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Returns a displayed sentence that names the worst of [modules], or says that none is. Only a clearly worse module is named: always
 * naming one would send people to healthy ones. A module with a target that turns farther than the others has larger errors without being
 * worse.
 */
fun worstModuleText(modules: List<ModuleError>): String {
    lackingText(modules)?.let { return it }
    val angle = sentenceOf(modules, "angle", ErrorUnit.DEGREES, CLEAR_DEGREES, ModuleError::angle) { it.isWorseThan(modules - it) }
    val speed = sentenceOf(modules, "speed", ErrorUnit.SPEED, CLEAR_SPEED, ModuleError::speed) { true }
    return listOfNotNull(angle, speed).joinToString(" ").ifEmpty {
        val sizes = modules.mapNotNull { it.angle?.rms }
        val range = ErrorUnit.DEGREES.textOf(sizes.min(), sizes.max())
        val areAlike = sizes.max() < sizes.min() * ALIKE || sizes.max() - sizes.min() < CLEAR_DEGREES
        if (areAlike) "The angle errors of the modules are alike: $range RMS." else "No module stands out: angle errors of $range RMS."
    }
}

/** Returns the reason why [modules] cannot be compared; null if they can. */
private fun lackingText(modules: List<ModuleError>): String? {
    val uncounted = modules.filter { it.target.time <= 0 }
    val withoutAngle = modules.filter { it.target.time > 0 && it.angle == null }
    val withoutSpeed = modules.filter { it.angle != null && it.speed == null }
    fun names(some: List<ModuleError>) = some.joinToString(" and ") { it.label }
    return when {
        uncounted.size == modules.size -> "No errors are counted in the visible range."
        withoutAngle.isNotEmpty() -> "The measured angle of ${names(withoutAngle)} is missing in the visible range."
        withoutSpeed.isNotEmpty() -> "The measured speed of ${names(withoutSpeed)} is missing in the visible range."
        uncounted.isNotEmpty() -> "No errors of ${names(uncounted)} count in the visible range."
        else -> null
    }
}

/**
 * Returns the sentence about the worst of [modules] by their [error]. Null unless it is clearly worse than the second worst, by at least
 * [clear], and [isBad].
 */
private fun sentenceOf(
    modules: List<ModuleError>,
    quantity: String,
    unit: ErrorUnit,
    clear: Double,
    error: (ModuleError) -> ErrorSize?,
    isBad: (ModuleError) -> Boolean,
): String? {
    fun rms(module: ModuleError) = error(module)?.rms ?: 0.0
    val (worst, second) = modules.sortedByDescending(::rms)
    if (rms(worst) < rms(second) * WORSE || rms(worst) - rms(second) < clear || !isBad(worst)) return null
    val range = unit.textOf(modules.filter { it !== worst }.minOf(::rms), rms(second))
    return "${worst.label} has the largest $quantity error: ${unit.textOf(rms(worst))} RMS, the others $range."
}

/** Whether this module's angle error is larger than in [others], for another reason than that its target turns farther. */
private fun ModuleError.isWorseThan(others: List<ModuleError>): Boolean = isSteady || lag >= WORSE * others.maxOf { it.lag }

/** The delay of the module's angle behind its target, in s; infinite if the target does not turn. */
private val ModuleError.lag: Double
    get() = (checkNotNull(angle).meanSize + RESOLUTION) * target.time / target.turned

/** Whether the angle is always off in the same direction. A delay behind a target that turns in one direction does not count. */
private val ModuleError.isSteady: Boolean
    get() = with(checkNotNull(angle)) { abs(mean) >= STEADY * rms && abs(mean) * target.time >= SLOW * abs(target.net) }

private const val WORSE = 1.5
private const val ALIKE = 1.5

/** The smallest difference in degrees that is worth a search for its cause. */
private const val CLEAR_DEGREES = 1.0

/** The smallest difference in m/s that is worth a search for its cause. */
private const val CLEAR_SPEED = 0.1

/** The resolution of sensors in degrees, which is not a delay. The same as for findings. */
private const val RESOLUTION = 0.2

/** The minimum ratio of the mean of a steady error to its root mean square. */
private const val STEADY = 0.8

/** The maximum delay of a healthy module behind its target, in s. */
private const val SLOW = 0.2

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
