package badlog.rules

import badlog.core.analysis.Span

/**
 * Returns [hits]; if there are many, hits less than a second apart are joined, because flicker is one event. If most hits are short, the
 * gap is doubled until few are left, up to 8 s.
 */
internal fun joinedHits(hits: List<Span>): List<Span> {
    if (hits.size <= MAX_HITS) return hits
    val areShort = hits.map { it.width }.sorted()[hits.size / 2] < SHORT_SECONDS
    var gap = 1.0
    var joined = joined(hits, gap)
    while (areShort && joined.size > MAX_MARKS && gap < MAX_GAP_SECONDS) {
        gap *= 2
        joined = joined(joined, gap)
    }
    return joined
}

private fun joined(spans: List<Span>, gap: Double): List<Span> {
    val joined = ArrayList<Span>()
    for (span in spans) {
        val last = joined.lastOrNull()
        if (last != null && span.from >= last.to && span.from - last.to < gap) {
            joined[joined.lastIndex] = Span(last.from, maxOf(last.to, span.to))
        } else {
            joined += span
        }
    }
    return joined
}

/** As many hits as a person goes through one by one. */
private const val MAX_HITS = 50

/** As many marks as leave a graph readable. */
private const val MAX_MARKS = 20
private const val SHORT_SECONDS = 0.5
private const val MAX_GAP_SECONDS = 8.0
