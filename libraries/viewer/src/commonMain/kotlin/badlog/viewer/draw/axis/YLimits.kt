package badlog.viewer.draw.axis

import badlog.core.analysis.Span
import kotlin.math.abs

/**
 * Returns the y limits that fit [least] to [most], and also 0 if [includesZero]. If nothing is visible, both are NaN, and the limits are
 * 0 to 1.
 */
fun limitsFor(least: Double, most: Double, includesZero: Boolean): Span {
    if (least.isNaN()) return Span(0.0, 1.0)
    val low = (if (includesZero) minOf(least, 0.0) else least).coerceIn(-MAX_MAGNITUDE, MAX_MAGNITUDE)
    val high = (if (includesZero) maxOf(most, 0.0) else most).coerceIn(-MAX_MAGNITUDE, MAX_MAGNITUDE)
    val isFlat = high - low <= abs(high) * FLAT
    // A margin of 0, a tenth of the smallest double, would leave an empty range.
    val margin = (if (isFlat) abs(high) * 0.1 else (high - low) * MARGIN).let { if (it == 0.0) 1.0 else it }
    // A line that is always 0 would be on the frame's edge.
    if (low == 0.0 && high == 0.0) return Span(-margin, margin)
    // Values that are never below 0 have no margin there: it would look as if they could be negative.
    return Span(
        from = if (low >= 0.0 && low - margin < 0.0) 0.0 else low - margin,
        to = if (high <= 0.0 && high + margin > 0.0 && low < 0.0) 0.0 else high + margin,
    )
}

private const val MARGIN = 0.07
private const val FLAT = 1e-12
private const val MAX_MAGNITUDE = 7e307
