package badlog.charts.look

import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.Scale
import org.jetbrains.letsPlot.scale.scaleXContinuous
import org.jetbrains.letsPlot.scale.scaleYContinuous
import kotlin.math.abs

/**
 * The area of a chart between its axes. It converts between values and points.
 *
 * @property x the ends of the horizontal axis.
 * @property y the ends of the vertical axis.
 */
internal class PlotArea(val x: ClosedFloatingPointRange<Double>, val y: ClosedFloatingPointRange<Double>) {
    /** The horizontal axis. */
    fun xScale(): Scale = scaleXContinuous(limits = x.start to x.endInclusive, expand = NOTHING)

    /** The vertical axis. */
    fun yScale(): Scale = scaleYContinuous(limits = y.start to y.endInclusive, expand = NOTHING)

    /** Returns the position of [x], in points from the left. */
    fun across(x: Double): Double = (x - this.x.start) / (this.x.endInclusive - this.x.start) * WIDTH

    /** Returns the position of [y], in points from the bottom. */
    fun up(y: Double): Double = (y - this.y.start) / (this.y.endInclusive - this.y.start) * HEIGHT

    /** Returns the value at [points] from the left. */
    fun xAt(points: Double): Double = x.start + points / WIDTH * (x.endInclusive - x.start)

    /** Returns the value at [points] from the bottom. */
    fun yAt(points: Double): Double = y.start + points / HEIGHT * (y.endInclusive - y.start)

    companion object {
        // An estimate: longer numbers beside the axis take a few points more.
        private const val WIDTH = 800.0
        private const val HEIGHT = 270.0
        private val NOTHING = listOf(0, 0)

        /** The space between the data and each end of an axis, as a share of the data's range. */
        private const val PADDING = 0.1

        /** Returns the ends of an axis for [values]; it begins at [least] or above, unless a value is below. */
        fun paddedRange(values: List<Double>, least: Double = Double.NEGATIVE_INFINITY): ClosedFloatingPointRange<Double> {
            val (from, to) = values.min() to values.max()
            val room = if (to > from) (to - from) * PADDING else maxOf(abs(to) * PADDING, PADDING)
            val begin = if (from >= least) maxOf(from - room, least) else from - room
            return begin..to + room
        }
    }
}

/** Returns this chart with the axes of [area]. */
internal fun Plot.within(area: PlotArea): Plot = this + area.xScale() + area.yScale()
