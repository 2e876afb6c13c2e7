package badlog.expression.samples

import badlog.analysis.TrapezoidSum

// One sample for each sample. What needs the one before has a gap at the first, and beside a gap.

internal fun Column.delta(): Column = with(DoubleArray(size) { if (it == 0) Double.NaN else y[it] - y[it - 1] })

/** The slope from the sample before; a gap where time stands still or goes back. */
internal fun Column.derivative(): Column = with(
    DoubleArray(size) {
        val run = if (it == 0) 0.0 else x[it] - x[it - 1]
        val isBroken = run <= 0 || stretches?.isSetBackBetween(x[it - 1], x[it]) == true
        if (isBroken) Double.NaN else (y[it] - y[it - 1]) / run
    },
)

/** The integral so far. */
internal fun Column.area(): Column {
    val sum = TrapezoidSum()
    return with(
        DoubleArray(size) {
            sum.add(x[it], y[it])
            if (y[it].isFinite()) sum.value else Double.NaN
        },
    )
}

internal fun Column.previous(): Column = withAlike(DoubleArray(size) { if (it == 0) Double.NaN else y[it - 1] })

/** Each gap filled with the value before it; an event stays until the next. */
internal fun Column.hold(): Column {
    var last = Double.NaN
    val samples = DoubleArray(size) {
        if (!y[it].isNaN()) last = y[it]
        last
    }
    return Column(x, samples, texts, stretches = stretches)
}

/** The same samples, [time] later. */
internal fun Column.shifted(time: Double): Column = Column(DoubleArray(size) { x[it] + time }, y, texts, isMomentary, stretches)

/** Whether a sample differs from the one before and neither is a gap. */
internal fun Column.changed(): Column = with(
    DoubleArray(size) { if (it > 0 && !y[it].isNaN() && !y[it - 1].isNaN() && y[it] != y[it - 1]) 1.0 else 0.0 },
)

/** Whether a sample is a gap or not finite. */
internal fun Column.missing(): Column = with(DoubleArray(size) { if (y[it].isFinite()) 0.0 else 1.0 })

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
