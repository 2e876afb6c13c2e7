package badlog.cli.merge

/**
 * The rows of several logs in one sequence. They are in the order of x if they have one. Rows of the same log always keep their order,
 * because its clock may have been set. A row that is the same in several logs, cell by cell, is included once.
 *
 * @param logs the logs; without x, they stay in this order.
 */
internal class AppendedRows(logs: List<LogPart>) {
    /** The logs, in the order in which they begin. */
    val parts: List<LogPart> = if (logs.any { it.xTopic == null }) logs else logs.sortedBy { it.firstX }
    private val total = parts.sumOf { it.recording.rowCount }
    private val rowParts = IntArray(total)
    private val rows = IntArray(total)

    var size = 0
        private set

    /** The number of rows skipped because another log also has them. */
    var repeated = 0
        private set

    init {
        if (parts.any { it.xTopic == null }) {
            for (part in parts.indices) for (row in 0 until parts[part].recording.rowCount) add(part, row)
        } else {
            interleave()
        }
    }

    /** Returns the index in [parts] of the log that has row [index]. */
    fun partOf(index: Int): Int = rowParts[index]

    /** Returns the index of row [index] within its own log. */
    fun rowOf(index: Int): Int = rows[index]

    /** Returns the x of row [index]; may be NaN. */
    fun x(index: Int): Double = parts[rowParts[index]].x[rows[index]]

    private fun interleave() {
        val next = IntArray(parts.size)
        val identities = HashMap<Pair<Int, Int>, RowIdentity>()
        while (true) {
            val part = earliest(next)
            if (part < 0) return
            val row = next[part]++
            add(part, row)
            val x = parts[part].x[row]
            for (other in parts.indices) {
                if (other == part || next[other] == parts[other].recording.rowCount || parts[other].x[next[other]] != x) continue
                val identity = identities.getOrPut(part to other) { RowIdentity(parts[part], parts[other]) }
                if (identity.isSame(row, next[other])) {
                    next[other]++
                    repeated++
                }
            }
        }
    }

    private fun earliest(next: IntArray): Int {
        var best = -1
        var bestX = Double.POSITIVE_INFINITY
        for (part in parts.indices) {
            if (next[part] == parts[part].recording.rowCount) continue
            val x = parts[part].x[next[part]]
            // A row without x stays after the previous one.
            if (x.isNaN()) return part
            if (best < 0 || x < bestX) {
                best = part
                bestX = x
            }
        }
        return best
    }

    private fun add(part: Int, row: Int) {
        rowParts[size] = part
        rows[size++] = row
    }
}
