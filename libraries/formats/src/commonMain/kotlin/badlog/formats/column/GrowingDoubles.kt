package badlog.formats.column

/** A growing list of numbers. It grows by pieces that are copied only once, at the end, instead of at every growth. */
internal class GrowingDoubles {
    private var full: ArrayList<DoubleArray>? = null
    private var fullSize = 0
    private var last = NONE
    private var lastSize = 0

    val size: Int get() = fullSize + lastSize

    fun add(number: Double) {
        if (lastSize == last.size) grow()
        last[lastSize++] = number
    }

    private fun grow() {
        if (lastSize > 0) {
            val pieces = full ?: ArrayList<DoubleArray>().also { full = it }
            pieces += last
            fullSize += lastSize
        }
        last = DoubleArray(fullSize.coerceIn(MIN_SIZE, MAX_SIZE))
        lastSize = 0
    }

    fun toArray(): DoubleArray {
        if (full == null && lastSize == last.size) return last
        val all = DoubleArray(size)
        var at = 0
        for (piece in full.orEmpty()) {
            piece.copyInto(all, at)
            at += piece.size
        }
        last.copyInto(all, at, 0, lastSize)
        return all
    }

    /** Returns all numbers and empties the list. */
    fun take(): DoubleArray {
        val all = toArray()
        full = null
        fullSize = 0
        last = NONE
        lastSize = 0
        return all
    }

    fun addAll(others: GrowingDoubles) {
        for (number in others.toArray()) add(number)
    }

    private companion object {
        val NONE = DoubleArray(0)
        const val MIN_SIZE = 4
        const val MAX_SIZE = 1 shl 14
    }
}
