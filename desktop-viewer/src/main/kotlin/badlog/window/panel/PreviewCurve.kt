package badlog.window.panel

import androidx.compose.foundation.Canvas
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.PointMode
import badlog.viewer.panel.Preview

/** Draws [preview] in the available room. */
@Composable
internal fun PreviewCurve(preview: Preview, color: Color, modifier: Modifier = Modifier) {
    Canvas(modifier) {
        for (line in preview.lines) {
            val points = List(line.size / 2) { i ->
                Offset(line[2 * i].toFloat() * size.width, line[2 * i + 1].toFloat() * (size.height - 1) + 0.5f)
            }
            // Lines up to one physical pixel thick are drawn many times faster.
            drawPoints(points, PointMode.Polygon, color, strokeWidth = 1f)
        }
    }
}
