package badlog.viewer.graph.plot

import badlog.analysis.Span
import badlog.plot.board.BoardGraph
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.theme.Palette

/**
 * What a graph's picture is to show.
 *
 * @property spec the graph.
 * @property recordings those it is drawn of.
 * @property visible the part of x.
 * @property width how many physical pixels that part takes; above 0.
 * @property height how many physical pixels y takes; above 0.
 * @property palette the colors.
 * @property sharing the other graphs that share their limits of y with it.
 * @property density how many physical pixels a dp has.
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
)
