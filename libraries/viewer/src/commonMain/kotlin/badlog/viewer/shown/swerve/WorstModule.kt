package badlog.viewer.shown.swerve

import kotlin.math.abs

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
