package badlog.expression.samples

import badlog.core.analysis.Span

/**
 * Spans of time, in chronological order.
 *
 * @property times the number of spans; one that was cut because the clock was set back counts once.
 */
internal class Spans(private val from: DoubleArray, private val to: DoubleArray, val times: Int = from.size) : AbstractList<Span>() {
    override val size: Int get() = from.size

    override fun get(index: Int): Span = Span(from[index], to[index])

    val total: Double
        get() {
            var sum = 0.0
            for (i in from.indices) sum += to[i] - from[i]
            return sum
        }
}

/**
 * Returns the spans in which this condition holds. Each lasts from a true sample to the next one that is not, or to [end], after which
 * nothing is known. Each true sample of a momentary condition is a span without width.
 */
internal fun Column.spans(end: Double): Spans {
    var known = size
    while (!isMomentary && known > 0 && x[known - 1] > end) known--
    var count = 0
    for (i in 0 until known) if (beginsAt(i)) count++
    val from = DoubleArray(count)
    val to = DoubleArray(count)
    var span = -1
    for (i in 0 until known) {
        if (beginsAt(i)) from[++span] = x[i]
        if (y[i] == 1.0) to[span] = until(i, end).let { if (it - x[i] <= 2 * tick(x[i]) && from[span] == x[i]) x[i] else it }
    }
    return stretches?.logged(from, to) ?: Spans(from, to)
}

private fun Stretches.logged(from: DoubleArray, to: DoubleArray): Spans {
    val loggedFrom = ArrayList<Double>()
    val loggedTo = ArrayList<Double>()
    for (i in from.indices) {
        eachPart(from[i], to[i]) { begin, end ->
            loggedFrom += begin
            loggedTo += end
        }
    }
    return Spans(loggedFrom.toDoubleArray(), loggedTo.toDoubleArray(), from.size)
}

private fun Column.beginsAt(index: Int) = y[index] == 1.0 && (isMomentary || index == 0 || y[index - 1] != 1.0)

/**
 * Returns a condition that holds within [spans] and not elsewhere in [range]. The end of a span is not included, except for the
 * end of the recording.
 */
internal fun stepsOf(spans: List<Span>, range: Span?): Column {
    if (range == null) return Column(DoubleArray(0), DoubleArray(0))
    val times = ArrayList<Double>()
    val states = ArrayList<Double>()
    fun set(time: Double, state: Double) {
        if (times.isNotEmpty() && time <= times.last()) {
            states[states.lastIndex] = state
        } else {
            times += time
            states += state
        }
    }
    set(range.from, 0.0)
    for (span in spans) {
        if (span.to <= range.from || span.from > range.to || span.width <= 0) continue
        set(maxOf(span.from, range.from), 1.0)
        if (span.to < range.to) set(span.to, 0.0)
    }
    return Column(times.toDoubleArray(), states.toDoubleArray())
}

/** Returns a condition that holds from time [from] until [to]; unknown if one of them is. */
internal fun during(from: Double, to: Double, range: Span?): Column {
    if (from.isNaN() || to.isNaN()) return unknown(range)
    return stepsOf(if (from < to) listOf(Span(from, to)) else emptyList(), range)
}

/** Returns a condition that is unknown over [range]. */
internal fun unknown(range: Span?): Column = stepsOf(emptyList(), range).let { it.with(DoubleArray(it.size) { Double.NaN }) }
