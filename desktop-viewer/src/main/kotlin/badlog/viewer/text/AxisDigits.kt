package badlog.viewer.text

import java.math.BigDecimal
import java.math.RoundingMode
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/** [value] with so many [decimals]. */
internal fun fixedText(value: Double, decimals: Int): String = when {
    !value.isFinite() || abs(value) >= LARGEST_WHOLE -> exactText(value)
    else -> BigDecimal(value).setScale(decimals, RoundingMode.HALF_UP).toPlainString()
}

/** How many decimals tell apart places on an axis of which [span] is visible. */
internal fun decimalsFor(span: Double): Int =
    if (span > 0) ceil(DECADES_SEEN - log10(span)).toInt().coerceIn(0, MOST_DECIMALS) else MOST_DECIMALS

/** How many decimals a multiple of [step] needs, which has one or, as 2.5 has, two digits. */
internal fun decimalsOf(step: Double): Int {
    if (!(step > 0)) return 0
    val ofFirst = ceil(-log10(step) - ROUNDING).toInt().coerceIn(0, MOST_TICK_DECIMALS)
    val scaled = step * 10.0.pow(ofFirst)
    val isWhole = abs(scaled - round(scaled)) <= scaled * ROUNDING
    return if (isWhole) ofFirst else minOf(ofFirst + 1, MOST_TICK_DECIMALS)
}

private const val LARGEST_WHOLE = 1e15
private const val DECADES_SEEN = 4
private const val MOST_DECIMALS = 9
private const val MOST_TICK_DECIMALS = 12
private const val ROUNDING = 1e-9
