package badlog.viewer.text

import badlog.analysis.Units
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.abs
import kotlin.math.floor

/** A sample exactly as it is, in as few digits as tell it from every other number; `–` for none. */
internal fun exactText(value: Double): String = when {
    value.isNaN() -> NONE
    value.isInfinite() -> if (value > 0) "∞" else "-∞"
    value == 0.0 -> "0"
    value == floor(value) && abs(value) < LARGEST_PLAIN -> value.toLong().toString()
    abs(value) in SMALLEST_PLAIN..LARGEST_PLAIN -> BigDecimal(value.toString()).stripTrailingZeros().toPlainString()
    else -> value.toString().replace(".0E", "E").replace('E', 'e')
}

/** A figure that was calculated, and so is not exact to the last of its digits: six of them. */
internal fun figureText(value: Double): String =
    if (value.isFinite()) exactText(BigDecimal(value).round(SIX_DIGITS).toDouble()) else exactText(value)

/** [text] and its [unit], where it has one. */
internal fun withUnit(text: String, unit: String): String = if (Units.isNone(unit) || text == NONE) text else "$text $unit"

private const val NONE = "–"
private const val SMALLEST_PLAIN = 1e-4
private const val LARGEST_PLAIN = 1e15
private val SIX_DIGITS = MathContext(6)
