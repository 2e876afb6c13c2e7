package badlog.viewer.recording

import badlog.analysis.Series
import badlog.plot.text.exactText
import badlog.plot.text.roundedText
import badlog.plot.text.withUnit

/** The index of the last sample at or before [position]; of the last of all for null; -1 when there is none. */
internal fun Series.lastAtOrBefore(position: Double?): Int {
    if (position == null) return size - 1
    if (!isOrdered) {
        var index = size - 1
        while (index >= 0 && !(x[index] <= position)) index--
        return index
    }
    // The first one after it, by halves: several samples may share an x.
    var low = 0
    var high = size
    while (low < high) {
        val middle = (low + high) ushr 1
        if (x[middle] <= position) low = middle + 1 else high = middle
    }
    return low - 1
}

/**
 * The index of the sample of [series], this signal's, that a cursor at [position] reads, the last one for null; -1 when there is
 * none. Of numbers that is the nearest one, on which the cursor's dot stands; a state lasts until the next, and so does what holds.
 */
internal fun Signal.indexAt(series: Series, position: Double?): Int =
    if (states != null || holds || position == null) series.lastAtOrBefore(position) else series.nearest(position)

/** What [signal] says at [position], or at its end for null: a number with its unit or the name of a state; `–` for a gap. */
internal fun valueText(signal: Signal, series: Series, position: Double?): String {
    val index = signal.indexAt(series, position)
    if (index < 0) return "–"
    val value = series.y[index]
    val states = signal.states ?: return if (value.isNaN()) "–" else withUnit(sampleText(signal, value), signal.unit)
    return if (value.isNaN()) "–" else states.getOrNull(value.toInt()) ?: exactText(value)
}

/** [value] as [signal] has it: exactly as it was logged, but without the digits that a calculation makes up. */
internal fun sampleText(signal: Signal, value: Double): String = if (signal.isDerived) roundedText(value) else exactText(value)
