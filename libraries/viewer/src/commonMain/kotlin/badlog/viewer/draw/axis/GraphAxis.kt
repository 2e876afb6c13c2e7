package badlog.viewer.draw.axis

import badlog.core.analysis.Span
import badlog.core.analysis.Units

/** The side of a graph with the numbers of a y axis. */
enum class AxisSide {
    /** The numbers are to the left of the graph. */
    LEFT,

    /** The numbers are to the right of the graph. */
    RIGHT,

    /**
     * The axis has no numbers: a graph has only two sides. Lines of a third unit have their own scale, but their values are only in the
     * legend.
     */
    NONE,
    ;

    /** Returns the legend's note on a line in [unit] on this axis. It has the unit, and the side of the numbers unless that is the left. */
    fun legendOf(unit: String): String = when (this) {
        LEFT -> unit
        RIGHT -> if (unit.isEmpty()) "right" else "$unit, right"
        NONE -> if (unit.isEmpty()) "own scale" else "$unit, own scale"
    }
}

/**
 * The y axis of the lines of a graph that share a unit.
 *
 * @property unit the unit; empty if there is none.
 * @property lines the indices of the axis' lines in the graph.
 */
class GraphAxis(val unit: String, val side: AxisSide, val lines: List<Int>)

/**
 * Returns the y axes for lines with [units]. The unit of a line that is not drawn is null, so that its axis is free for another unit. The
 * first unit is on the left, the second on the right; further ones have no numbers.
 */
fun graphAxes(units: List<String?>): List<GraphAxis> {
    val linesOf = LinkedHashMap<String, ArrayList<Int>>()
    units.forEachIndexed { line, unit ->
        if (unit != null) linesOf.getOrPut(if (Units.isNone(unit)) "" else unit) { ArrayList() } += line
    }
    return linesOf.entries.mapIndexed { i, (unit, lines) -> GraphAxis(unit, AxisSide.entries[minOf(i, AxisSide.entries.lastIndex)], lines) }
}

/**
 * Returns the visible range of each of [axes]. Its whole range in [wholes] fits the visible samples, see [limitsFor]; a person may have
 * selected the range on the [left] and on the [right]. Other axes show the same part of their whole range as the left one, so that all
 * lines move together.
 */
fun axisLimits(axes: List<GraphAxis>, wholes: List<Span>, left: Span?, right: Span? = null): List<Span> {
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

/** Returns the part of [whole] that corresponds to [chosen] in [first]; null if numbers are too coarse for it. */
private fun alike(chosen: Span, first: Span, whole: Span): Span? = Span(
    whole.from + (chosen.from - first.from) / first.width * whole.width,
    whole.from + (chosen.to - first.from) / first.width * whole.width,
).takeIf(::isShowable)

/** Returns the same [part] of each of [limits], given as fractions from the top. */
fun yParts(limits: List<Span>, part: Span): List<Span> = limits.map { Span(it.to - part.to * it.width, it.to - part.from * it.width) }

private fun isShowable(span: Span) = span.width > 0 && span.width.isFinite()
