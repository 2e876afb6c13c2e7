package badlog.window.panel

import androidx.compose.foundation.Canvas
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.PointMode
import androidx.compose.ui.graphics.drawscope.DrawScope
import badlog.core.analysis.Span
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.panel.Preview

/** Draws [preview] in the available room. */
@Composable
internal fun PreviewCurve(preview: Preview, color: Color, modifier: Modifier = Modifier) {
    val topic = preview.topic
    val range = preview.range
    Canvas(modifier) {
        var run = ArrayList<Offset>()
        for (column in 0 until PreviewLine.COLUMNS) {
            if (topic.preview.has(column)) {
                addColumn(run, column, topic, range)
            } else if (run.isNotEmpty()) {
                drawRun(run, color)
                run = ArrayList()
            }
        }
        drawRun(run, color)
    }
}

/** Adds the two ends of [column] to [run]: first the end that is nearer to the last point. */
private fun DrawScope.addColumn(run: MutableList<Offset>, column: Int, topic: TopicSummary, range: Span) {
    val width = size.width / PreviewLine.COLUMNS
    val low = heightOf(topic.preview.low(column), topic, range)
    val high = heightOf(topic.preview.high(column), topic, range)
    val last = run.lastOrNull()?.y ?: high
    val beginsLow = last - high > low - last
    run += Offset((column + 0.25f) * width, if (beginsLow) low else high)
    run += Offset((column + 0.75f) * width, if (beginsLow) high else low)
}

private fun DrawScope.heightOf(share: Float, topic: TopicSummary, range: Span): Float {
    val statistics = topic.statistics
    val value = statistics.min + (statistics.max - statistics.min) * share
    val place = if (range.width > 0) (value - range.from) / range.width else 0.5
    return ((1 - (if (place.isNaN()) 0.5 else place).coerceIn(0.0, 1.0)) * (size.height - 1) + 0.5).toFloat()
}

private fun DrawScope.drawRun(points: List<Offset>, color: Color) {
    // Lines up to one physical pixel thick are drawn many times faster.
    if (points.isNotEmpty()) drawPoints(points, PointMode.Polygon, color, strokeWidth = 1f)
}
