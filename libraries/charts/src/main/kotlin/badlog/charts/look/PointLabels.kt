package badlog.charts.look

import org.jetbrains.letsPlot.geom.geomText
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.tooltips.tooltipsNone
import kotlin.math.abs
import kotlin.math.pow

/** A [text] beside the point at [x] and [y]. */
internal class PointLabel(val x: Double, val y: Double, val text: String)

/**
 * Returns this chart with [labels], each above or below its point, or beside it. Labels without free space are left out, the last ones
 * first.
 *
 * @param points all points, which no label may cover.
 * @param isBelow whether a place below the points is preferred.
 * @param isLogarithmic whether the y of labels, points and area are logarithms of the values on the vertical axis.
 */
internal fun Plot.withLabels(
    labels: List<PointLabel>,
    points: List<Pair<Double, Double>>,
    area: PlotArea,
    isLogarithmic: Boolean = false,
    isBelow: Boolean = false,
): Plot {
    val space = LabelSpace(area, points)
    val placed = labels.mapNotNull { space.place(it, if (isBelow) -ABOVE else ABOVE) }
    if (placed.isEmpty()) return this
    val data = mapOf(
        "x" to placed.map { it.x },
        "y" to placed.map { if (isLogarithmic) 10.0.pow(it.y) else it.y },
        "text" to placed.map { it.text },
    )
    return this + geomText(data, color = ChartColors.TEXT, size = LABEL_SIZE, family = "sans-serif", tooltips = tooltipsNone) {
        x = "x"
        y = "y"
        label = "text"
    }
}

/** The occupied space of an area, in points. */
private class LabelSpace(private val area: PlotArea, points: List<Pair<Double, Double>>) {
    private val taken = points.mapTo(ArrayList()) { (x, y) -> Box(area.across(x), area.up(y), DOT, DOT) }
    private val all =
        Box(
            area.across(area.x.endInclusive) / 2,
            area.up(area.y.endInclusive) / 2,
            area.across(area.x.endInclusive),
            area.up(area.y.endInclusive),
        )

    /** Returns [label] with the position of its middle, [first] points above its point or at another free place. Null if none is free. */
    fun place(label: PointLabel, first: Double): PointLabel? {
        val (x, y) = area.across(label.x) to area.up(label.y)
        val width = label.text.length * CHARACTER
        val aside = width / 2 + BESIDE
        for ((right, up) in listOf(0.0 to first, 0.0 to -first, aside to 0.0, -aside to 0.0)) {
            val box = Box(x + right, y + up, width, LINE)
            if (!all.contains(box) || taken.any(box::touches)) continue
            taken += box
            return PointLabel(area.xAt(box.x), area.yAt(box.y), label.text)
        }
        return null
    }
}

/** A box around [x] and [y]. */
private class Box(val x: Double, val y: Double, private val width: Double, private val height: Double) {
    fun touches(other: Box) = abs(x - other.x) < (width + other.width) / 2 && abs(y - other.y) < (height + other.height) / 2

    fun contains(other: Box) = abs(x - other.x) <= (width - other.width) / 2 && abs(y - other.y) <= (height - other.height) / 2
}

/** The font size of texts in a chart, in the unit of its library. */
internal const val LABEL_SIZE = 6.5

/** Sizes in points: of a letter, a line and a dot, and the distances of a text from its dot. */
private const val CHARACTER = 8.5
private const val LINE = 14.0
private const val DOT = 7.0
private const val ABOVE = 13.0
private const val BESIDE = 8.0
