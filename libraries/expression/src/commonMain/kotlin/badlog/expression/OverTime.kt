package badlog.expression

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
