package badlog.plot.axis

import badlog.analysis.Span
import kotlin.math.abs

/**
 * The limits of y that make room for [least] to [most], both NaN when there is nothing to see, and for 0 when it [includesZero]: what is
 * seen fills them.
 */
public fun limitsFor(least: Double, most: Double, includesZero: Boolean): Span {
    if (least.isNaN()) return Span(0.0, 1.0)
    val low = (if (includesZero) minOf(least, 0.0) else least).coerceIn(-MAX_MAGNITUDE, MAX_MAGNITUDE)
    val high = (if (includesZero) maxOf(most, 0.0) else most).coerceIn(-MAX_MAGNITUDE, MAX_MAGNITUDE)
    val isFlat = high - low <= abs(high) * FLAT
    // Of the smallest numbers there are, a tenth is nothing.
    val margin = (if (isFlat) abs(high) * 0.1 else (high - low) * MARGIN).let { if (it == 0.0) 1.0 else it }
    // A line of nothing but 0 would lie on the frame's edge.
    if (low == 0.0 && high == 0.0) return Span(-margin, margin)
    // What never goes below 0 gets no room there: it would look as if it could.
    return Span(
        from = if (low >= 0.0 && low - margin < 0.0) 0.0 else low - margin,
        to = if (high <= 0.0 && high + margin > 0.0 && low < 0.0) 0.0 else high + margin,
    )
}

private const val MARGIN = 0.07
private const val FLAT = 1e-12
private const val MAX_MAGNITUDE = 7e307
