package badlog.core.analysis

/**
 * Returns the [indices] in ascending order of their [keys]. Equal keys keep their order, and NaN comes last. It uses a bottom-up merge
 * sort, which allocates no object per index.
 */
public fun stableOrder(keys: DoubleArray, indices: IntArray = IntArray(keys.size) { it }): IntArray {
    var from = indices.copyOf()
    var to = IntArray(indices.size)
    val size = from.size.toLong()
    var width = 1L
    while (width < size) {
        var start = 0L
        while (start < size) {
            merge(from, to, keys, start.toInt(), minOf(start + width, size).toInt(), minOf(start + 2 * width, size).toInt())
            start += 2 * width
        }
        to = from.also { from = to }
        width *= 2
    }
    return from
}

private fun merge(from: IntArray, to: IntArray, keys: DoubleArray, start: Int, middle: Int, end: Int) {
    var left = start
    var right = middle
    for (i in start until end) {
        val takesLeft = right == end || (left < middle && keys[from[left]].compareTo(keys[from[right]]) <= 0)
        to[i] = if (takesLeft) from[left++] else from[right++]
    }
}
