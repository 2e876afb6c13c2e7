package badlog.samples.bag

import kotlin.math.abs

/** The format in which a robot's program writes numbers. */
enum class NumberText {
    /** A logger's default: `%.5g`. */
    FIVE_DIGITS,

    /** A team's own function: no more decimals than the sensor has. */
    SENSOR_DECIMALS,
}

/** Returns [value] with at most [decimals] decimals and without trailing zeros, rounded half up. */
fun decimalText(value: Double, decimals: Int): String {
    if (!value.isFinite()) return value.toString()
    var scale = 1L
    repeat(decimals) { scale *= 10 }
    val rounded = Math.floor(abs(value) * scale + 0.5).toLong()
    val whole = (rounded / scale).toString()
    val fraction = (rounded % scale).toString().padStart(decimals, '0').trimEnd('0')
    val sign = if (value < 0 && rounded != 0L) "-" else ""
    return if (decimals == 0 || fraction.isEmpty()) sign + whole else "$sign$whole.$fraction"
}
