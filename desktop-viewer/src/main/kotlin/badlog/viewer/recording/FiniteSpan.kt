package badlog.viewer.recording

import badlog.analysis.Span

/** From the smallest to the largest of [positions] that are finite; null when none is. */
internal fun finiteSpan(positions: DoubleArray): Span? {
    var from = Double.POSITIVE_INFINITY
    var to = Double.NEGATIVE_INFINITY
    for (x in positions) {
        if (!x.isFinite()) continue
        if (x < from) from = x
        if (x > to) to = x
    }
    return if (from <= to) Span(from, to) else null
}
