package badlog.cli.merge

/** Several sequences of rows side by side: a row for each x of any of them. Rows with the same x become one row. */
internal class JoinedRows(private val groups: List<AppendedRows>) {
    private val rows = List(groups.size) { IntArray(groups.sumOf { it.size }) }

    var size = 0
        private set

    init {
        val next = IntArray(groups.size)
        while (groups.indices.any { next[it] < groups[it].size }) {
            val x = minX(next)
            var isAlone = false
            for (group in groups.indices) {
                val isNext = next[group] < groups[group].size && !isAlone && isSame(groups[group].x(next[group]), x)
                rows[group][size] = if (isNext) next[group]++ else NONE
                isAlone = isAlone || (isNext && x.isNaN())
            }
            size++
        }
    }

    /** Returns the row of [group] in row [index], or [NONE]. */
    fun rowOf(group: Int, index: Int): Int = rows[group][index]

    /** Returns the x of row [index]; may be NaN. */
    fun x(index: Int): Double {
        val group = groups.indices.first { rows[it][index] != NONE }
        return groups[group].x(rows[group][index])
    }

    /** Returns NaN if a row without x is next, which does not share its row. */
    private fun minX(next: IntArray): Double {
        var least = Double.POSITIVE_INFINITY
        for (group in groups.indices) {
            if (next[group] == groups[group].size) continue
            val x = groups[group].x(next[group])
            if (x.isNaN()) return x
            if (x < least) least = x
        }
        return least
    }

    private fun isSame(x: Double, y: Double) = x == y || (x.isNaN() && y.isNaN())

    companion object {
        /** The index of a row that does not exist. */
        const val NONE = -1
    }
}
