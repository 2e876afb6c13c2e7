package badlog.viewer.shown.cursor

import badlog.core.analysis.GraphSeries
import badlog.signals.pose.lastAtOrBefore
import badlog.viewer.choices.range.wholeRange
import badlog.viewer.text.numberText

/**
 * Returns the index of the sample that a cursor at [x] reads on this line; -1 outside the line's recording, or if [x] is NaN.
 *
 * All front ends share this rule. Values that hold until they change, such as states and topics with times of their own, are read from
 * the last sample at or before the cursor, so nothing is read before the first sample. Numbers that were measured row by row, and
 * calculated ones, are read from the nearest sample, on which the cursor's dot is drawn.
 */
fun GraphSeries.indexAt(x: Double): Int = when {
    x !in wholeRange -> -1
    states != null || holds -> data.lastAtOrBefore(x)
    else -> data.nearest(x)
}

/**
 * Returns the x of a cursor's dot on this line, for a cursor at [x]. It is at the cursor if the value holds, otherwise at the sample. NaN
 * if there is none.
 */
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
 * Returns sample [index] of this line as text: the name of its state, or its number formatted by [sampleText]. `–` for a gap, and for an
 * index without a sample.
 */
fun GraphSeries.textOf(index: Int, sampleText: (Double) -> String = ::numberText): String {
    if (index !in 0 until data.size) return NOTHING
    val value = data.y[index]
    if (value.isNaN()) return NOTHING
    return states?.let { it.getOrElse(value.toInt()) { "?" } } ?: sampleText(value)
}

private const val NOTHING = "–"
