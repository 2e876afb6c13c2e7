package badlog.viewer.shown.cursor

import badlog.core.analysis.GraphSeries
import badlog.signals.pose.lastAtOrBefore
import badlog.viewer.choices.range.wholeRange
import badlog.viewer.text.numberText

/**
 * Returns the index of the sample of this line that a cursor at [x] reads; -1 for none: before and after its recording, and if [x] is NaN.
 *
 * One rule for all front ends: values that hold until they change, such as states and topics with times of their own, are read
 * from the last sample at or before the cursor; there is no value before their first sample. Numbers that were measured row by
 * row, and calculated ones, are read from the nearest sample, on which the cursor's dot is drawn.
 */
fun GraphSeries.indexAt(x: Double): Int = when {
    x !in wholeRange -> -1
    states != null || holds -> data.lastAtOrBefore(x)
    else -> data.nearest(x)
}

/** Returns the x of the dot of a cursor at [x] on this line: at the cursor if the value holds, otherwise at its sample; NaN for none. */
fun GraphSeries.dotAt(x: Double): Double {
    val index = indexAt(x)
    return if (index < 0) {
        Double.NaN
    } else if (holds) {
        x
    } else {
        data.x[index]
    }
}

/**
 * Returns sample [index] of this line as text: the name of its state, or its number formatted by [sampleText]; `–` for a gap, and
 * if there is no such sample.
 */
fun GraphSeries.textOf(index: Int, sampleText: (Double) -> String = ::numberText): String {
    if (index !in 0 until data.size) return NOTHING
    val value = data.y[index]
    if (value.isNaN()) return NOTHING
    return states?.let { it.getOrElse(value.toInt()) { "?" } } ?: sampleText(value)
}

private const val NOTHING = "–"
