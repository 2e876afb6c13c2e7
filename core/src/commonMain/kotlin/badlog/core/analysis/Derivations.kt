package badlog.core.analysis

/**
 * Returns the differences between neighbors, `y[i+1] - y[i]`, each at the midpoint of `x[i]` and `x[i+1]`. The result has one sample fewer
 * than the series, and a gap wherever a neighbor has no finite value.
 */
public fun Series.delta(): Series = betweenNeighbors { i -> y[i + 1] - y[i] }

/**
 * Returns the slopes between neighbors, `(y[i+1] - y[i]) / (x[i+1] - x[i])`, each at the midpoint of `x[i]` and `x[i+1]`. The result has
 * one sample fewer than the series, and a gap wherever a neighbor has no finite value, or x does not increase.
 */
public fun Series.derivative(): Series = betweenNeighbors { i ->
    val run = x[i + 1] - x[i]
    val slope = if (run > 0) (y[i + 1] - y[i]) / run else Double.NaN
    if (slope.isFinite()) slope else Double.NaN
}

/**
 * Returns the running area under the series by the trapezoidal rule. It is 0 at the first value, and each sum is at the sample that ends
 * its interval. Over a gap, and where x goes backwards, the sum stays unchanged, because the area there is not known.
 *
 * @param holds whether each sample holds until the next one, as in a topic that is logged when it changes; the area is then
 * made of rectangles.
 */
public fun Series.integral(holds: Boolean = false): Series {
    val sums = DoubleArray(size)
    val sum = AreaSum()
    for (i in 0 until size) {
        val width = if (i == 0) Double.NaN else x[i] - x[i - 1]
        val height = if (i == 0 || holds) y[maxOf(0, i - 1)] else y[i] / 2 + y[i - 1] / 2
        if (width >= 0) sum.addArea(width * height)
        sums[i] = if (y[i].isFinite()) sum.value else Double.NaN
    }
    return Series(x, sums)
}

private inline fun Series.betweenNeighbors(value: (Int) -> Double): Series {
    val count = maxOf(0, size - 1)
    val middles = DoubleArray(count)
    val values = DoubleArray(count)
    for (i in 0 until count) {
        middles[i] = x[i] + (x[i + 1] - x[i]) / 2
        values[i] = if (y[i].isFinite() && y[i + 1].isFinite()) value(i) else Double.NaN
    }
    return Series(middles, values)
}
