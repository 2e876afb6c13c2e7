package badlog.analysis

/**
 * The smallest and the largest finite value of any range of an array, found in a time that hardly depends on the range:
 * each level holds both for blocks of [BLOCK] entries of the level below. Takes a sixteenth of the array's memory.
 */
internal class MinMaxPyramid(private val values: DoubleArray) {
    private val mins = ArrayList<DoubleArray>()
    private val maxs = ArrayList<DoubleArray>()

    /** The smallest finite value of the range that [find] looked at last; NaN when it has none. */
    var min = Double.NaN
        private set

    /** The largest finite value of the range that [find] looked at last; NaN when it has none. */
    var max = Double.NaN
        private set

    init {
        if (values.size > BLOCK) addLevel(values, values)
        while (mins.isNotEmpty() && mins.last().size > BLOCK) addLevel(mins.last(), maxs.last())
    }

    private fun addLevel(lowest: DoubleArray, highest: DoubleArray) {
        val blocks = (lowest.size + BLOCK - 1) / BLOCK
        val levelMins = DoubleArray(blocks)
        val levelMaxs = DoubleArray(blocks)
        for (block in 0 until blocks) {
            clear()
            scan(lowest, highest, block * BLOCK, minOf((block + 1) * BLOCK, lowest.size))
            levelMins[block] = min
            levelMaxs[block] = max
        }
        mins += levelMins
        maxs += levelMaxs
    }

    /** Finds [min] and [max] of the values from [from] until [until]. */
    fun find(from: Int, until: Int) {
        clear()
        var start = from
        var end = until
        var lowest = values
        var highest = values
        for (level in mins.indices) {
            if (end - start < 2 * BLOCK) break
            val firstWhole = (start + BLOCK - 1) / BLOCK
            val endWhole = end / BLOCK
            scan(lowest, highest, start, firstWhole * BLOCK)
            scan(lowest, highest, endWhole * BLOCK, end)
            start = firstWhole
            end = endWhole
            lowest = mins[level]
            highest = maxs[level]
        }
        scan(lowest, highest, start, end)
    }

    private fun clear() {
        min = Double.NaN
        max = Double.NaN
    }

    private fun scan(lowest: DoubleArray, highest: DoubleArray, from: Int, until: Int) {
        var least = if (min.isNaN()) Double.POSITIVE_INFINITY else min
        var most = if (max.isNaN()) Double.NEGATIVE_INFINITY else max
        for (i in from until until) {
            val low = lowest[i]
            val high = highest[i]
            if (low < least && low > Double.NEGATIVE_INFINITY) least = low
            if (high > most && high < Double.POSITIVE_INFINITY) most = high
        }
        if (least <= most) {
            min = least
            max = most
        }
    }

    private companion object {
        const val BLOCK = 32
    }
}
