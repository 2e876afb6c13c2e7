package badlog.samples.bag

import kotlin.math.abs

/** How a robot's program writes its numbers. */
enum class NumberText {
    /** As a logger does by default: `%.5g`. */
    FIVE_DIGITS,

    /** With a text function of the team's own: no more decimals than the sensor has. */
    SENSOR_DECIMALS,
}

/** [value] with at most [decimals] decimals and no zeros at their end, rounded half up. */
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
