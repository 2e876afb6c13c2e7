package badlog.plot.cursor

import badlog.analysis.GraphSeries
import badlog.analysis.Units
import badlog.plot.text.roundedText
import badlog.plot.text.withUnit

/**
 * What this line says at a cursor at [a] and at another at [b], the difference, and the slope from one to the other: `A 12.1 · B 9.3 ·
 * Δ -2.8 · -1.4 V/s`. Without difference and slope for states and gaps.
 *
 * @param xUnit the unit of x.
 * @param numberText how a sample is written.
 */
public fun GraphSeries.comparisonText(a: Double, b: Double, xUnit: String, numberText: (Double) -> String): String {
    val one = indexAt(a)
    val other = indexAt(b)
    val texts = "A ${textOf(one, numberText)} · B ${textOf(other, numberText)}"
    if (states != null || one < 0 || other < 0) return texts
    val change = data.y[other] - data.y[one]
    if (change.isNaN()) return texts
    val slope = change / (dotAt(b) - dotAt(a))
    val text = "$texts · Δ ${roundedText(change)}"
    return if (slope.isFinite()) "$text · ${withUnit(roundedText(slope), Units.ofDerivative(unit, xUnit))}" else text
}
