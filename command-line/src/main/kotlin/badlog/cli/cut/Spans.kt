package badlog.cli.cut

import badlog.core.analysis.Span
import java.util.BitSet

/** Returns [spans] in ascending order, with those that touch or overlap joined. */
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

/** Returns the intersection of [one] and [other]. The spans of each ascend and do not touch. */
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

/** Returns the rows in one of [spans]; [positions] has the x of each row. A row without x belongs to the previous row. */
internal fun rowsIn(positions: DoubleArray, spans: List<Span>): BitSet {
    val rows = BitSet(positions.size)
    val apart = joined(spans)
    var isIn = false
    for (row in positions.indices) {
        val x = positions[row]
        if (!x.isNaN()) isIn = isInside(x, apart)
        if (isIn) rows.set(row)
    }
    return rows
}

/** Returns the rows that are set, as runs of consecutive rows. */
internal fun BitSet.runs(): List<IntRange> = buildList {
    var from = nextSetBit(0)
    while (from >= 0) {
        val until = nextClearBit(from)
        add(from until until)
        from = nextSetBit(until)
    }
}

private fun isInside(x: Double, spans: List<Span>): Boolean {
    // Uses operators, for which 0 and -0 are equal.
    val place = spans.binarySearch {
        if (it.from < x) {
            -1
        } else if (it.from > x) {
            1
        } else {
            0
        }
    }
    if (place >= 0) return true
    val before = -place - 2
    return before >= 0 && x <= spans[before].to
}
