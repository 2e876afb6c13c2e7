package badlog.expression.samples

import badlog.core.analysis.AreaSum

// Functions of a value and its neighbors in time. A value that is logged repeatedly counts as one that holds: the results do not depend on
// how often it was logged. Next to a gap, the result is a gap.

/** Returns the change at each moment at which the value changes. */
internal fun Column.delta(): Column = atChanges { if (it == 0) Double.NaN else y[it] - y[it - 1] }

/** Returns a condition that is true at each moment at which the value changes. */
internal fun Column.changed(): Column = atChanges { if (it > 0 && !y[it].isNaN() && !y[it - 1].isNaN() && y[it] != y[it - 1]) 1.0 else 0.0 }

/** Returns moments: the first sample, and each that differs from the previous one. */
private inline fun Column.atChanges(value: (Int) -> Double): Column {
    var count = 0
    for (i in 0 until size) if (begins(i)) count++
    val times = if (count == size) x else DoubleArray(count)
    val samples = DoubleArray(count)
    var next = 0
    for (i in 0 until size) {
        if (!begins(i)) continue
        if (count < size) times[next] = x[i]
        samples[next++] = value(i)
    }
    return Column(times, samples, null, isMomentary = true, stretches)
}

/** Returns whether sample [index] is not just a repetition of the value before it. Moments are never repetitions. */
private fun Column.begins(index: Int) =
    index == 0 || isMomentary || !(y[index] == y[index - 1] || (y[index].isNaN() && y[index - 1].isNaN()))

/**
 * Returns the slope from each change to the next; a gap where time does not advance. After the last change, the value stays the
 * same: the slope is 0.
 */
internal fun Column.derivative(): Column {
    val slopes = DoubleArray(size)
    var begin = 0
    for (i in 1..size) {
        if (i < size && !begins(i)) continue
        slopes.fill(if (i < size) slope(begin, i) else y.getOrElse(begin) { 0.0 } * 0.0, begin, i)
        begin = i
    }
    return with(slopes)
}

private fun Column.slope(from: Int, to: Int): Double {
    val run = x[to] - x[from]
    val isBroken = run <= 0 || stretches?.isSetBackBetween(x[from], x[to]) == true
    return if (isBroken) Double.NaN else (y[to] - y[from]) / run
}

/** Returns the integral up to each sample. */
internal fun Column.area(): Column {
    val sum = AreaSum()
    return with(
        DoubleArray(size) {
            sum.add(x[it], y[it])
            if (y[it].isFinite()) sum.value else Double.NaN
        },
    )
}

/** Returns the value before the current one. */
internal fun Column.previous(): Column {
    var before = Double.NaN
    return withAlike(
        DoubleArray(size) {
            if (it > 0 && begins(it)) before = y[it - 1]
            before
        },
    )
}

/** Returns this with each gap filled with the previous value; an event holds until the next. */
internal fun Column.hold(): Column {
    var last = Double.NaN
    val samples = DoubleArray(size) {
        if (!y[it].isNaN()) last = y[it]
        last
    }
    return Column(x, samples, texts, stretches = stretches)
}

/** Returns the same samples, [time] later. */
internal fun Column.shifted(time: Double): Column = Column(DoubleArray(size) { x[it] + time }, y, texts, isMomentary, stretches)

/** Returns whether each sample is a gap or not finite. */
internal fun Column.missing(): Column = with(DoubleArray(size) { if (y[it].isFinite()) 0.0 else 1.0 })

/** Returns a condition that is true wherever this one holds for [length] or longer without a break. The last sample holds until [end]. */
internal fun Column.heldFor(length: Double, end: Double): Column {
    val states = y.copyOf()
    var begin = 0
    for (i in 1..size) {
        if (i < size && (y[i] == 1.0) == (y[begin] == 1.0)) continue
        val until = if (i < size) minOf(x[i], end) else end
        if (y[begin] == 1.0 && until - x[begin] < length - slack(length, until)) states.fill(0.0, begin, i)
        begin = i
    }
    return with(states)
}

/**
 * Returns these samples, with additional ones every [step], until [end], where a sample holds for longer. Results from topics with their
 * own times then follow time in the same way as results from rows.
 */
internal fun Column.refined(step: Double, end: Double): Column {
    if (size == 0 || isMomentary) return this
    val interval = maxOf(step, (end - x[0]) / MAX_STEPS)
    fun stepsAfter(index: Int): Int {
        val width = (if (index + 1 < size) minOf(x[index + 1], end) else end) - x[index]
        return if (width > interval * LONG) (width / interval - HALF).toInt() else 0
    }
    var count = size
    for (i in 0 until size) count += stepsAfter(i)
    if (count == size) return this
    val times = DoubleArray(count)
    val samples = DoubleArray(count)
    var next = 0
    for (i in 0 until size) {
        for (k in 0..stepsAfter(i)) {
            times[next] = x[i] + k * interval
            samples[next++] = y[i]
        }
    }
    return Column(times, samples, texts, isMomentary, stretches)
}

/**
 * Returns these moments as samples that hold. Each is in the first of [rows] at or after it; all other rows have [rest]. Without rows, each
 * is a pulse without width: its value, immediately followed by [rest].
 */
internal fun Column.pulses(rows: DoubleArray?, rest: Double): Column {
    if (rows != null && rows.all { it.isFinite() }) return inRows(stretches?.steady(rows) ?: rows, rest)
    val times = DoubleArray(2 * size) { x[it / 2] }
    return Column(times, DoubleArray(2 * size) { if (it % 2 == 0) y[it / 2] else rest }, texts, stretches = stretches)
}

private fun Column.inRows(rows: DoubleArray, rest: Double): Column {
    var next = 0
    val samples = DoubleArray(rows.size) { row ->
        var value = rest
        while (next < size && x[next] <= rows[row]) {
            if (!y[next].isNaN() && y[next] != rest) value = y[next]
            next++
        }
        value
    }
    return Column(rows, samples, texts, stretches = stretches)
}

private const val MAX_STEPS = 200_000

// Allows for jitter in the times of rows.
private const val LONG = 1.5
private const val HALF = 0.5
