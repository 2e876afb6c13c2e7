package badlog.charts.look

import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.Scale
import org.jetbrains.letsPlot.scale.scaleXContinuous
import org.jetbrains.letsPlot.scale.scaleYContinuous
import kotlin.math.abs

/**
 * The part of a chart that has the data: what its axes show, and so where a point is.
 *
 * @property x the ends of the horizontal axis.
 * @property y the ends of the vertical axis.
 */
internal class PlotArea(val x: ClosedFloatingPointRange<Double>, val y: ClosedFloatingPointRange<Double>) {
    /** The horizontal axis. */
    fun xScale(): Scale = scaleXContinuous(limits = x.start to x.endInclusive, expand = NOTHING)

    /** The vertical axis. */
    fun yScale(): Scale = scaleYContinuous(limits = y.start to y.endInclusive, expand = NOTHING)

    /** Returns where [x] is, in points from the left. */
    fun across(x: Double): Double = (x - this.x.start) / (this.x.endInclusive - this.x.start) * WIDTH

    /** Returns where [y] is, in points from the bottom. */
    fun up(y: Double): Double = (y - this.y.start) / (this.y.endInclusive - this.y.start) * HEIGHT

    /** Returns the value that is [points] from the left. */
    fun xAt(points: Double): Double = x.start + points / WIDTH * (x.endInclusive - x.start)

    /** Returns the value that is [points] from the bottom. */
    fun yAt(points: Double): Double = y.start + points / HEIGHT * (y.endInclusive - y.start)

    companion object {
        // Some points less for numbers with more digits do not matter.
        private const val WIDTH = 800.0
        private const val HEIGHT = 270.0
        private val NOTHING = listOf(0, 0)

        /** As large a part of an axis as its ends are away from the data. */
        private const val ROOM = 0.1

        /** Returns the ends of an axis for [values]; it does not begin below [least], unless they do. */
        fun roomFor(values: List<Double>, least: Double = Double.NEGATIVE_INFINITY): ClosedFloatingPointRange<Double> {
            val (from, to) = values.min() to values.max()
            val room = if (to > from) (to - from) * ROOM else maxOf(abs(to) * ROOM, ROOM)
            val begin = if (from >= least) maxOf(from - room, least) else from - room
            return begin..to + room
        }
    }
}

/** Returns this chart with the axes of [area]. */
internal fun Plot.within(area: PlotArea): Plot = this + area.xScale() + area.yScale()
