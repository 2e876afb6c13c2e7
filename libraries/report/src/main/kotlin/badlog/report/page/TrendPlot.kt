package badlog.report.page

import badlog.rules.comparison.threeDigitText
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.draw.pen.TextSide

/**
 * A number of one match, for a plot over the matches.
 *
 * @property value the number for the match called [name]; NaN for none.
 * @property uncertainty its uncertainty; NaN if unknown.
 * @property isOdd whether it is far from the others.
 */
internal class TrendPoint(val name: String, val value: Double, val uncertainty: Double = Double.NaN, val isOdd: Boolean = false)

/** Returns [points] as a small plot with a line at their median; null if fewer than two have a value. */
internal fun trendPlot(title: String, unit: String, points: List<TrendPoint>): String? {
    val known = points.filter { it.value.isFinite() }
    if (known.size < 2) return null
    val sorted = known.map { it.value }.sorted()
    val usual = (sorted[(sorted.size - 1) / 2] + sorted[sorted.size / 2]) / 2
    val (lowest, highest) = known.minBy { it.value } to known.maxBy { it.value }
    val said = "${known.size} matches, from ${text(lowest, unit)} to ${text(highest, unit)}, usually ${threeDigitText(usual, unit)}"
    val caption = "${escaped(title)}<small>usually ${escaped(threeDigitText(usual, unit))}</small>"
    val pen = SvgPen({ _, _, _ -> 0.0 }, cssOf = ::themed)
    TrendPlot(points, known, unit).draw(pen, usual, if (lowest.value == highest.value) listOf(lowest) else listOf(lowest, highest))
    val picture = pen.document(WIDTH, HEIGHT, colors[Shade.SURFACE])
    val label = escaped("$title: $said")
    return "<figure><figcaption>$caption</figcaption>\n<div role=\"img\" aria-label=\"$label\">$picture</div></figure>\n"
}

private class TrendPlot(private val points: List<TrendPoint>, known: List<TrendPoint>, private val unit: String) {
    private val from = known.minOf { it.value - it.spread }
    private val to = known.maxOf { it.value + it.spread }
    private val room = maxOf((to - from) * ROOM, Math.abs(to) * 1e-6, 1e-9)

    fun draw(pen: SvgPen, usual: Double, extremes: List<TrendPoint>) {
        pen.segments(Points().line(LEFT, y(usual), RIGHT, y(usual)), colors[Shade.MUTED], 1.0, DASH)
        for (extreme in extremes) {
            pen.text(threeDigitText(extreme.value, ""), LEFT - GAP, y(extreme.value), LETTERS, colors[Shade.MUTED], TextSide.LEFT)
        }
        val places = points.indices.filter { points[it].value.isFinite() }
        val line = Points()
        for (place in places) line.add(x(place), y(points[place].value))
        pen.chain(line, isClosed = false, colors[Shade.ACCENT], LINE)
        for (place in places) pen.titled("${points[place].name}: ${threeDigitText(points[place].value, unit)}") { drawPoint(pen, place) }
        pen.text("first match", LEFT, BELOW, LETTERS, colors[Shade.MUTED])
        pen.text("last match", RIGHT, BELOW, LETTERS, colors[Shade.MUTED], TextSide.LEFT)
    }

    private fun drawPoint(pen: SvgPen, place: Int) {
        val point = points[place]
        val (x, y) = x(place) to y(point.value)
        if (point.spread > 0) {
            val range = Points().line(x, y(point.value - point.spread), x, y(point.value + point.spread))
            pen.segments(range, faded(colors[Shade.ACCENT], RANGE_OPACITY), 1.0)
        }
        if (point.isOdd) {
            pen.dots(Points().add(x, y), ODD, colors[Shade.ERROR])
            pen.ring(x, y, ODD, colors[Shade.SURFACE], LINE)
        } else {
            pen.dots(Points().add(x, y), if (points.size > MAX_LARGE_POINTS) SMALL else LARGE, colors[Shade.ACCENT])
        }
    }

    private fun x(place: Int) = LEFT + (RIGHT - LEFT) * place / (points.size - 1)

    private fun y(value: Double) = BOTTOM - (value - from + room) / (to - from + 2 * room) * (BOTTOM - TOP)
}

private val TrendPoint.spread get() = if (uncertainty.isFinite()) uncertainty else 0.0

private fun text(point: TrendPoint, unit: String) = "${threeDigitText(point.value, unit)} (${point.name})"

private val colors = PenColors.LIGHT

/** Returns the page's variable for [color], which changes with the theme. */
private fun themed(color: Int): String = THEME.getValue(color and 0xFFFFFF)

private val THEME = listOf(Shade.SURFACE, Shade.MUTED, Shade.ACCENT, Shade.ERROR)
    .associate { it.of(isDark = false) to "var(--${it.name.lowercase()})" }

private const val WIDTH = 320.0
private const val HEIGHT = 116.0
private const val LEFT = 44.0
private const val RIGHT = 312.0
private const val TOP = 8.0
private const val BOTTOM = 98.0
private const val BELOW = 110.0
private const val GAP = 6.0
private const val LETTERS = 11.0
private const val ROOM = 0.08
private const val DASH = 3.0
private const val LINE = 1.5
private const val RANGE_OPACITY = 0.55
private const val MAX_LARGE_POINTS = 60
private const val SMALL = 1.5
private const val LARGE = 2.5
private const val ODD = 4.5
