package badlog.cli.cut

import badlog.plot.Span

/** The same places of x in spans that ascend and do not touch. */
internal fun joined(spans: List<Span>): List<Span> {
    val joined = ArrayList<Span>()
    for (span in spans.filter { it.from <= it.to }.sortedBy { it.from }) {
        val last = joined.lastOrNull()
        if (last != null && span.from <= last.to) {
            joined[joined.size - 1] = Span(last.from, maxOf(last.to, span.to))
        } else {
            joined += span
        }
    }
    return joined
}

/** The places of x that are in one of [one] and in one of [other], both of which ascend and do not touch. */
internal fun intersection(one: List<Span>, other: List<Span>): List<Span> = buildList {
    var i = 0
    var j = 0
    while (i < one.size && j < other.size) {
        val from = maxOf(one[i].from, other[j].from)
        val to = minOf(one[i].to, other[j].to)
        if (from <= to) add(Span(from, to))
        if (one[i].to < other[j].to) i++ else j++
    }
}
