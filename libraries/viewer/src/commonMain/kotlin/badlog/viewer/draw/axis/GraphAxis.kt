package badlog.viewer.draw.axis

import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.viewer.draw.curve.Strokes
import kotlin.math.abs

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

/**
 * The visible range of one unit in one graph.
 *
 * @property unit the unit; empty if there is none.
 * @property least the smallest value; NaN if there is none.
 * @property most the largest value; NaN if there is none.
 */
data class SeenOfUnit(val unit: String, val least: Double, val most: Double)

/** Returns the visible range on each of [axes], for lines with these [strokes]. */
fun seenOn(axes: List<GraphAxis>, strokes: List<Strokes>): List<SeenOfUnit> = axes.map { axis ->
    val seen = axis.lines.map(strokes::get).filter { !it.min.isNaN() }
    SeenOfUnit(axis.unit, seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN)
}

/** Returns the visible range of each unit in all graphs that share their limits. [seen] has an entry for each of their axes. */
fun seenTogether(seen: List<SeenOfUnit>): Map<String, SeenOfUnit> {
    val together = HashMap<String, SeenOfUnit>()
    for (one in seen) {
        if (one.least.isNaN()) continue
        val other = together[one.unit] ?: one
        together[one.unit] = SeenOfUnit(one.unit, minOf(one.least, other.least), maxOf(one.most, other.most))
    }
    return together
}

/**
 * Returns the y limits that fit [least] to [most], and also 0 if [includesZero]. If nothing is visible, both are NaN, and the limits are
 * 0 to 1.
 */
fun limitsFor(least: Double, most: Double, includesZero: Boolean): Span {
    if (least.isNaN()) return Span(0.0, 1.0)
    val low = (if (includesZero) minOf(least, 0.0) else least).coerceIn(-MAX_MAGNITUDE, MAX_MAGNITUDE)
    val high = (if (includesZero) maxOf(most, 0.0) else most).coerceIn(-MAX_MAGNITUDE, MAX_MAGNITUDE)
    val isFlat = high - low <= abs(high) * FLAT
    // A margin of 0, a tenth of the smallest double, would leave an empty range.
    val margin = (if (isFlat) abs(high) * 0.1 else (high - low) * MARGIN).let { if (it == 0.0) 1.0 else it }
    // A line that is always 0 would be on the frame's edge.
    if (low == 0.0 && high == 0.0) return Span(-margin, margin)
    // Values that are never below 0 have no margin there: it would look as if they could be negative.
    return Span(
        from = if (low >= 0.0 && low - margin < 0.0) 0.0 else low - margin,
        to = if (high <= 0.0 && high + margin > 0.0 && low < 0.0) 0.0 else high + margin,
    )
}

private const val MARGIN = 0.07
private const val FLAT = 1e-12
private const val MAX_MAGNITUDE = 7e307
