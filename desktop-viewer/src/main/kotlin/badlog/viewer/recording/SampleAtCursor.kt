package badlog.viewer.recording

import badlog.plot.cursor.indexAt
import badlog.plot.cursor.textOf
import badlog.plot.text.exactText
import badlog.plot.text.roundedText
import badlog.plot.text.withUnit

/**
 * What [signal] says at [position], or at its end for null: a number with its unit or the name of a state; `–` for a gap.
 * A logged number is exact, a calculated one without the digits that a calculation makes up.
 */
internal fun valueText(signal: Signal, position: Double?): String {
    val index = if (position == null) signal.series.size - 1 else signal.line.indexAt(position)
    return signal.line.textOf(index) { withUnit(if (signal.isDerived) roundedText(it) else exactText(it), signal.unit) }
}
