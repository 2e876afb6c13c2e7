package badlog.cli.cut

import badlog.plot.Span
import java.util.BitSet

/** Which rows of [positions], the x of each, lie in one of [spans]. A row without x goes with the row before it. */
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

/** The rows that are set, as runs of neighbours. */
internal fun BitSet.runs(): List<IntRange> = buildList {
    var from = nextSetBit(0)
    while (from >= 0) {
        val until = nextClearBit(from)
        add(from until until)
        from = nextSetBit(until)
    }
}

private fun isInside(x: Double, spans: List<Span>): Boolean {
    // By the operators, to which 0 and -0 are the same.
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
