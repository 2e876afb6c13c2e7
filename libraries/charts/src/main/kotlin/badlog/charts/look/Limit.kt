package badlog.charts.look

import org.jetbrains.letsPlot.geom.geomHLine
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/** A [value] at which something becomes a problem, and what it is called in the [text] below a chart. */
internal class Limit(val value: Double, val text: String) {
    /**
     * Returns whether a chart of [values] shows it: a limit far from all of them would press them together, unless one is a problem. Those
     * below it are if [isWorseBelow], otherwise those above it.
     */
    fun isShownWith(values: List<Double>, isWorseBelow: Boolean): Boolean {
        val span = values.max() - values.min()
        val isProblem = if (isWorseBelow) values.min() < value else values.max() > value
        return isProblem || value in values.min() - span..values.max() + span
    }

    /** The text that explains its line. */
    val reading: String get() = "red: $text"
}

/** Returns this chart with a line at [limit], which the text below the chart explains; without if it is null. */
internal fun Plot.withLimit(limit: Limit?): Plot =
    if (limit == null) this else this + geomHLine(yintercept = limit.value, color = ChartColors.LIMIT, size = 0.6, tooltips = tooltipsNone)
