package badlog.window.graph.plot

import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.plot.PlotFrame
import badlog.window.compare.DrawnRecording
import badlog.window.theme.Palette

/**
 * A request for a graph's picture.
 *
 * @property spec the graph.
 * @property recordings the recordings it shows.
 * @property visible the visible part of x.
 * @property width the width of that part in physical pixels; above 0.
 * @property height the height of y in physical pixels; above 0.
 * @property palette the colors.
 * @property sharing the other graphs that share their y limits with it.
 * @property density the number of physical pixels per dp.
 */
internal data class PlotRequest(
    val spec: BoardGraph,
    val recordings: List<DrawnRecording>,
    val visible: Span,
    val width: Int,
    val height: Int,
    val palette: Palette,
    val density: Float,
    val sharing: List<BoardGraph> = emptyList(),
) {
    /** The frame of its picture. */
    val frame: PlotFrame get() = PlotFrame(0.0, 0.0, width.toDouble(), height.toDouble(), visible)
}
