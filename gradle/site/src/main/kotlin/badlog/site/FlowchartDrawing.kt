package badlog.site

import com.mxgraph.layout.hierarchical.mxHierarchicalLayout
import com.mxgraph.model.mxCell
import com.mxgraph.util.mxPoint
import com.mxgraph.view.mxGraph
import java.util.Locale
import kotlin.math.atan2
import kotlin.math.max

/** Returns [chart] as an SVG element in the colors of the page. Its boxes are in layers, so that each arrow points down. */
internal fun drawingOf(chart: Flowchart): String {
    val graph = mxGraph()
    val boxes = LinkedHashMap<String, mxCell>()

    fun boxOf(name: String) = boxes.getOrPut(name) {
        graph.insertVertex(graph.defaultParent, null, name, 0.0, 0.0, name.length * LETTER + 2 * MARGIN, HEIGHT) as mxCell
    }
    val lines = chart.arrows.map { arrow ->
        val (from, to) = boxOf(arrow.from) to boxOf(arrow.to)
        arrow to graph.insertEdge(graph.defaultParent, null, arrow.label, from, to) as mxCell
    }
    mxHierarchicalLayout(graph).apply {
        intraCellSpacing = BETWEEN
        interRankCellSpacing = BELOW
    }.execute(graph.defaultParent)

    val points = lines.map { (_, line) -> pointsOf(line) }
    val width = max(boxes.values.maxOf { it.geometry.x + it.geometry.width }, points.flatten().maxOf { it.x })
    val height = boxes.values.maxOf { it.geometry.y + it.geometry.height }
    return buildString {
        val name = "A chart of ${boxes.size} boxes; the list below has the same."
        append(
            "<svg role=\"img\" aria-label=\"$name\" viewBox=\"-1 -1 ${number(
                width + 2,
            )} ${number(height + 2)}\" width=\"${number(width + 2)}\">\n",
        )
        for (line in points) append(arrow(line))
        for ((arrow, line) in lines.map { it.first }.zip(points)) if (arrow.label.isNotEmpty()) append(label(arrow.label, line))
        for ((text, cell) in boxes) append(box(text, cell))
        append("</svg>")
    }
}

/** Returns the bends of [line], from the bottom of its first box to the top of its last one. */
private fun pointsOf(line: mxCell): List<mxPoint> {
    val from = line.source.geometry
    val to = line.target.geometry
    val bends = line.geometry.points.orEmpty()
    return listOf(mxPoint(from.centerX, from.y + from.height)) + bends + mxPoint(to.centerX, to.y)
}

private fun arrow(points: List<mxPoint>): String {
    val (before, end) = points.takeLast(2)
    val turn = Math.toDegrees(atan2(end.y - before.y, end.x - before.x))
    val path = points.joinToString(" L", "M") { "${number(it.x)} ${number(it.y)}" }
    return "<path d=\"$path\"/><path class=\"head\" d=\"M0 0 L-9 -4 L-9 4 Z\" transform=\"translate(${number(
        end.x,
    )} ${number(end.y)}) rotate(${number(turn)})\"/>\n"
}

private fun label(text: String, points: List<mxPoint>): String {
    val (from, to) = points.zipWithNext().maxBy { (a, b) -> (b.y - a.y) * (b.y - a.y) + (b.x - a.x) * (b.x - a.x) }
    return "<text class=\"label\" x=\"${number(
        maxOf(from.x, to.x) + MARGIN / 2,
    )}\" y=\"${number((from.y + to.y) / 2)}\">${escape(text)}</text>\n"
}

private fun box(text: String, cell: mxCell): String = with(cell.geometry) {
    "<rect x=\"${number(x)}\" y=\"${number(y)}\" width=\"${number(width)}\" height=\"${number(height)}\" rx=\"5\"/>" +
        "<text x=\"${number(centerX)}\" y=\"${number(centerY)}\">${escape(text)}</text>\n"
}

private fun number(value: Double): String = String.format(Locale.ROOT, "%.1f", value).removeSuffix(".0")

/** The maximum average width of a letter in the drawing, in pixels. */
private const val LETTER = 7.8
private const val MARGIN = 12.0
private const val HEIGHT = 32.0
private const val BETWEEN = 28.0
private const val BELOW = 60.0
