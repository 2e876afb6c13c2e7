package badlog.expression

/**
 * True from the moment on at which this condition has held for [length]; where none of its samples stands at that moment, one is
 * put in. The last sample holds until [end].
 */
internal fun Column.heldFor(length: Double, end: Double): Column {
    val times = DoubleArray(size + countMoments(length, end))
    val states = DoubleArray(times.size)
    var count = 0
    var begin = Double.NaN
    for (i in 0 until size) {
        if (y[i] != 1.0) {
            begin = Double.NaN
        } else if (begin.isNaN()) {
            begin = x[i]
        }
        times[count] = x[i]
        states[count++] = if (y[i] != 1.0) {
            y[i]
        } else if (isReached(begin, length, x[i])) {
            1.0
        } else {
            0.0
        }
        if (momentComesAfter(i, begin, length, end)) {
            times[count] = begin + length
            states[count++] = 1.0
        }
    }
    return Column(if (count == size) x else times, states, stretches = stretches)
}

private fun Column.countMoments(length: Double, end: Double): Int {
    var count = 0
    var begin = Double.NaN
    for (i in 0 until size) {
        if (y[i] != 1.0) {
            begin = Double.NaN
        } else if (begin.isNaN()) {
            begin = x[i]
        }
        if (momentComesAfter(i, begin, length, end)) count++
    }
    return count
}

/** Whether the moment lies between sample [index] and what follows it. */
private fun Column.momentComesAfter(index: Int, begin: Double, length: Double, end: Double): Boolean {
    if (y[index] != 1.0 || isReached(begin, length, x[index])) return false
    return if (index + 1 == size) begin + length <= end else x[index + 1] - begin > length + slack(length, x[index + 1])
}

private fun isReached(begin: Double, length: Double, time: Double) = time - begin >= length - slack(length, time)
