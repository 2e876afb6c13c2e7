package badlog.window.graph

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.Placeable
import androidx.compose.ui.layout.SubcomposeLayout
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp

/**
 * Places [title] and then [count] entries from left to right, in at most [maxLines] lines. If some do not fit, [more] follows the
 * others, and receives the index of the first missing one.
 */
@Composable
internal fun LegendFlow(
    count: Int,
    maxLines: Int,
    modifier: Modifier = Modifier,
    title: @Composable () -> Unit,
    entry: @Composable (Int) -> Unit,
    more: @Composable (first: Int) -> Unit,
) {
    SubcomposeLayout(modifier) { constraints ->
        val gap = GAP.roundToPx()
        val reserve = gap + MORE_WIDTH.roundToPx()
        val width = constraints.maxWidth
        val loose = Constraints(maxWidth = maxOf(0, width - reserve))

        fun measured(key: Any, content: @Composable () -> Unit) = subcompose(key, content).firstOrNull()?.measure(loose)
        val lines = arrayListOf(ArrayList<Placeable>())
        measured("title", title)?.let { lines.last().add(it) }
        var shown = 0
        while (shown < count) {
            val index = shown
            val placeable = measured(index) { entry(index) } ?: break
            val isLastLine = lines.size == maxLines
            val room = if (isLastLine && index < count - 1) width - reserve else width
            val used = lines.last().sumOf { it.width + gap }
            if (lines.last().isNotEmpty() && used + placeable.width > room) {
                if (isLastLine) break
                lines.add(ArrayList())
            }
            lines.last().add(placeable)
            shown++
        }
        val first = shown
        if (first < count) measured("more") { more(first) }?.let { lines.last().add(it) }
        val heights = lines.map { line -> line.maxOfOrNull { it.height } ?: 0 }
        layout(width, heights.sum().coerceIn(constraints.minHeight, constraints.maxHeight)) {
            var top = 0
            lines.forEachIndexed { i, line ->
                var left = 0
                for (placeable in line) {
                    placeable.placeRelative(left, top + (heights[i] - placeable.height) / 2)
                    left += placeable.width + gap
                }
                top += heights[i]
            }
        }
    }
}

private val GAP = 14.dp

/** The room for the button that replaces the missing entries. */
private val MORE_WIDTH = 36.dp
