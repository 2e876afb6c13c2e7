package badlog.plot.axis

import badlog.analysis.Span
import badlog.analysis.Units

/** Where the numbers of a y axis stand. */
public enum class AxisSide {
    /** At the left of the graph. */
    LEFT,

    /** At its right. */
    RIGHT,

    /** Nowhere: a graph has two sides, so that lines of a third unit have a scale of their own, and their values in the legend alone. */
    NONE,
}

/**
 * The y axis of the lines of a graph that have one unit.
 *
 * @property unit it; empty for none.
 * @property lines which lines of the graph it is of, by their places in it.
 */
public class GraphAxis(public val unit: String, public val side: AxisSide, public val lines: List<Int>) {
    /** What a legend says of each of [lines]: the unit, and where its numbers stand if that is not at the left. */
    public val legend: String
        get() = when (side) {
            AxisSide.LEFT -> unit
            AxisSide.RIGHT -> if (unit.isEmpty()) "right" else "$unit, right"
            AxisSide.NONE -> if (unit.isEmpty()) "own scale" else "$unit, own scale"
        }
}

/**
 * The y axes of a graph whose lines have [units], null for one that is not drawn: a line that is hidden gives its axis to another unit. The
 * first unit stands at the left, the second one at the right, further ones nowhere.
 */
public fun graphAxes(units: List<String?>): List<GraphAxis> {
    val linesOf = LinkedHashMap<String, ArrayList<Int>>()
    units.forEachIndexed { line, unit ->
        if (unit != null) linesOf.getOrPut(if (Units.isNone(unit)) "" else unit) { ArrayList() } += line
    }
    return linesOf.entries.mapIndexed { i, (unit, lines) -> GraphAxis(unit, AxisSide.entries[minOf(i, AxisSide.entries.lastIndex)], lines) }
}

/**
 * What each of [axes] shows, given the [wholes] that would fit what is seen of them, see [limitsFor]. A person may have chosen what is shown
 * at the [left] and at the [right]; axes without a choice keep the same part of theirs as the left one, so that all lines move together.
 */
public fun axisLimits(axes: List<GraphAxis>, wholes: List<Span>, left: Span?, right: Span? = null): List<Span> {
    val first = wholes.firstOrNull() ?: return emptyList()
    return axes.mapIndexed { i, axis ->
        val whole = wholes[i]
        val chosen = when (axis.side) {
            AxisSide.LEFT -> left
            AxisSide.RIGHT -> right
            AxisSide.NONE -> null
        }
        chosen?.takeIf(::isShowable) ?: left?.takeIf { i > 0 && isShowable(it) }?.let { alike(it, first, whole) } ?: whole
    }
}

/** The part of [whole] that [chosen] is of [first]; null where numbers end. */
private fun alike(chosen: Span, first: Span, whole: Span): Span? = Span(
    whole.from + (chosen.from - first.from) / first.width * whole.width,
    whole.from + (chosen.to - first.from) / first.width * whole.width,
).takeIf(::isShowable)

private fun isShowable(span: Span) = span.width > 0 && span.width.isFinite()
