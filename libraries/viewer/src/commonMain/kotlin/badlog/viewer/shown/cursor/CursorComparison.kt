package badlog.viewer.shown.cursor

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Units
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit

/**
 * Returns the values of this line at cursors at [a] and [b]. The difference and the slope follow: `A 12.1 · B 9.3 · Δ -2.8 · -1.4 V/s`.
 * States and gaps have no difference and slope.
 *
 * @param xUnit the unit of x.
 * @param sampleText formats a sample.
 */
fun GraphSeries.comparisonText(a: Double, b: Double, xUnit: String, sampleText: (Double) -> String = ::numberText): String {
    val one = indexAt(a)
    val other = indexAt(b)
    val texts = "A ${textOf(one, sampleText)} · B ${textOf(other, sampleText)}"
    if (states != null || one < 0 || other < 0) return texts
    val change = data.y[other] - data.y[one]
    if (change.isNaN()) return texts
    val slope = change / (dotAt(b) - dotAt(a))
    val text = "$texts · Δ ${numberText(change)}"
    return if (slope.isFinite()) "$text · ${withUnit(numberText(slope), Units.ofDerivative(unit, xUnit))}" else text
}
