package badlog.charts.look

import org.jetbrains.letsPlot.geom.geomHLine
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/** A [value] at which something becomes a problem, with its [text] below a chart. */
internal class Limit(val value: Double, val text: String) {
    /**
     * Returns whether a chart of [values] shows the limit. A limit far from all of them would squeeze them together, so it is shown only if
     * it is near, or a value is a problem: below the limit if [isWorseBelow], otherwise above it.
     */
    fun isShownWith(values: List<Double>, isWorseBelow: Boolean): Boolean {
        val span = values.max() - values.min()
        val isProblem = if (isWorseBelow) values.min() < value else values.max() > value
        return isProblem || value in values.min() - span..values.max() + span
    }

    /** The text that explains its line. */
    val reading: String get() = "red: $text"
}

/** Returns this chart with a line at [limit], which the text below the chart explains; unchanged if [limit] is null. */
internal fun Plot.withLimit(limit: Limit?): Plot =
    if (limit == null) this else this + geomHLine(yintercept = limit.value, color = ChartColors.LIMIT, size = 0.6, tooltips = tooltipsNone)
