package badlog.report.page

import badlog.rules.comparison.figureText
import java.util.Locale

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
    val said = "${known.size} matches, from ${text(lowest, unit)} to ${text(highest, unit)}, usually ${figureText(usual, unit)}"
    val from = known.minOf { it.value - it.spread }
    val to = known.maxOf { it.value + it.spread }
    val room = maxOf((to - from) * ROOM, Math.abs(to) * 1e-6, 1e-9)
    val y = { value: Double -> BOTTOM - (value - from + room) / (to - from + 2 * room) * (BOTTOM - TOP) }
    val x = { place: Int -> LEFT + (RIGHT - LEFT) * if (points.size == 1) 0.5 else place.toDouble() / (points.size - 1) }
    val caption = "${escaped(title)}<small>usually ${escaped(figureText(usual, unit))}</small>"
    val out = StringBuilder("<figure><figcaption>$caption</figcaption>\n")
    out.append("<svg viewBox=\"0 0 $WIDTH $HEIGHT\" role=\"img\" aria-label=\"${escaped("$title: $said")}\">\n")
    val height = number(y(usual))
    out.append("<line class=\"usual\" x1=\"${number(LEFT)}\" x2=\"${number(RIGHT)}\" y1=\"$height\" y2=\"$height\"/>\n")
    for (extreme in if (lowest.value == highest.value) listOf(lowest) else listOf(lowest, highest)) {
        out.append("<text x=\"${number(LEFT - GAP)}\" y=\"${number(y(extreme.value) + TEXT_SHIFT)}\" text-anchor=\"end\">")
        out.append("${escaped(figureText(extreme.value, ""))}</text>\n")
    }
    val places = points.indices.filter { points[it].value.isFinite() }
    out.append("<polyline class=\"line\" points=\"${places.joinToString(" ") { "${number(x(it))},${number(y(points[it].value))}" }}\"/>\n")
    val radius = if (points.size > MANY) SMALL else LARGE
    for (place in places) {
        val point = points[place]
        if (point.spread > 0) {
            out.append("<line class=\"range\" x1=\"${number(x(place))}\" x2=\"${number(x(place))}\" ")
            out.append("y1=\"${number(y(point.value - point.spread))}\" y2=\"${number(y(point.value + point.spread))}\"/>\n")
        }
        val (size, kind) = if (point.isOdd) ODD to " class=\"odd\"" else radius to ""
        out.append("<circle$kind cx=\"${number(x(place))}\" cy=\"${number(y(point.value))}\" r=\"${number(size)}\">")
        out.append("<title>${escaped("${point.name}: ${figureText(point.value, unit)}")}</title></circle>\n")
    }
    out.append("<text x=\"${number(LEFT)}\" y=\"${number(HEIGHT - 2.0)}\">first match</text>\n")
    out.append("<text x=\"${number(RIGHT)}\" y=\"${number(HEIGHT - 2.0)}\" text-anchor=\"end\">last match</text>\n")
    return out.append("</svg></figure>\n").toString()
}

private val TrendPoint.spread get() = if (uncertainty.isFinite()) uncertainty else 0.0

private fun text(point: TrendPoint, unit: String) = "${figureText(point.value, unit)} (${point.name})"

private fun number(value: Double): String = String.format(Locale.ROOT, "%.1f", value)

private const val WIDTH = 320
private const val HEIGHT = 116
private const val LEFT = 44.0
private const val RIGHT = 312.0
private const val TOP = 8.0
private const val BOTTOM = 98.0
private const val GAP = 6.0
private const val TEXT_SHIFT = 4.0
private const val ROOM = 0.08
private const val MANY = 60
private const val SMALL = 1.5
private const val LARGE = 2.5
private const val ODD = 4.5
