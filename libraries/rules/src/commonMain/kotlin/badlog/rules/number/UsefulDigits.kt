package badlog.rules.number

import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/**
 * Returns [value], rounded to the five digits that are useful for comparing. A stored number then takes less space, and does not depend on
 * the order in which a sum was added up.
 */
internal fun usefulDigits(value: Double): Double {
    if (value == 0.0 || !value.isFinite()) return value
    val places = 10.0.pow(DIGITS - 1 - floor(log10(abs(value))).toInt())
    return round(value * places) / places
}

private const val DIGITS = 5
