package badlog.expression.samples

import badlog.core.analysis.Span

// When and how often a condition becomes true. One that is true at the start becomes true there.

/** Returns the moments at which this condition becomes true. */
internal fun Column.rises(range: Span?): Column = occurrences(end(range)).let { moments(it.map(Span::from)) { 1.0 } }

/** Returns the moments at which this condition stops being true. */
internal fun Column.falls(range: Span?): Column {
    val end = end(range)
    val places = (1 until size).filter { y[it] == 0.0 && y[it - 1] == 1.0 && !isMomentary && x[it] <= end }
    return moments(places.map { x[it] }) { 1.0 }
}

/** Returns, at each moment at which this condition becomes true, the time for which it stays true. */
internal fun Column.lengths(range: Span?): Column = occurrences(end(range)).let { all -> moments(all.map(Span::from)) { all[it].width } }

/** Returns, at each moment at which this condition becomes true again, the time since it last became true. */
internal fun Column.cycleTimes(range: Span?): Column {
    val begins = occurrences(end(range)).map { it.from }
    return moments(begins.drop(1)) { begins[it + 1] - begins[it] }
}

/** Returns a condition that is true while this one is, and for [length] after. */
internal fun Column.after(length: Double, range: Span?): Column = within(range) { Span(it.from, it.to + length) }

/** Returns a condition that is true for [length] before this one becomes true. */
internal fun Column.before(length: Double, range: Span?): Column = within(range) { Span(it.from - length, it.from) }

/** Returns a condition that holds during the first [length] of this condition's first occurrence. */
internal fun Column.firstPart(length: Double, range: Span?): Column {
    val first = occurrences(end(range)).firstOrNull()
    return within(range) { if (it == first) Span(it.from, minOf(it.to, it.from + length)) else null }
}

/** Returns a condition that holds during the last [length] of this condition's last occurrence. */
internal fun Column.lastPart(length: Double, range: Span?): Column {
    val last = occurrences(end(range)).lastOrNull()
    return within(range) { if (it == last) Span(maxOf(it.from, it.to - length), it.to) else null }
}

/** Returns the times at which it holds, on the clock of [Column.x]. */
private fun Column.occurrences(end: Double): List<Span> {
    val spans = ArrayList<Span>()
    for (i in 0 until size) {
        if (y[i] != 1.0 || (!isMomentary && x[i] > end)) continue
        val goesOn = !isMomentary && i > 0 && y[i - 1] == 1.0
        if (goesOn) spans[spans.lastIndex] = Span(spans.last().from, until(i, end)) else spans += Span(x[i], until(i, end))
    }
    return spans
}

private inline fun Column.moments(times: List<Double>, value: (Int) -> Double): Column =
    Column(times.toDoubleArray(), DoubleArray(times.size) { value(it) }, null, isMomentary = true, stretches)

/** Returns a condition that is true in the [part] of each time that this one holds. It is unknown if this one is never known. */
private inline fun Column.within(range: Span?, part: (Span) -> Span?): Column {
    val start = stretches?.begin ?: range?.from ?: return unknown(range)
    if (!isMomentary && y.all { it.isNaN() }) return Column(doubleArrayOf(start), doubleArrayOf(Double.NaN), stretches = stretches)
    val end = end(range)
    val parts = ArrayList<Span>()
    for (span in occurrences(end)) {
        val wanted = part(span) ?: continue
        if (wanted.to <= maxOf(start, wanted.from)) continue
        // A condition that is still true continues.
        val goesOn = parts.isNotEmpty() && parts.last().to >= wanted.from
        if (goesOn) parts[parts.lastIndex] = Span(parts.last().from, wanted.to) else parts += wanted
    }
    val times = arrayListOf(start)
    val states = arrayListOf(if (parts.isNotEmpty() && parts[0].from <= start) 1.0 else 0.0)
    for (span in parts) {
        if (span.from > start) {
            times += span.from
            states += 1.0
        }
        // A span that holds until the end of the log includes that end.
        if (span.to != end) {
            times += span.to
            states += 0.0
        }
    }
    return Column(times.toDoubleArray(), states.toDoubleArray(), stretches = stretches)
}
