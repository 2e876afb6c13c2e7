package badlog.page.view

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Curve
import badlog.viewer.shown.comparison.ComparedLog
import badlog.viewer.text.unitText

/**
 * The visible values in all graphs of [board] that share their y limits. A graph need not be on the screen.
 *
 * @param compared returns the logs that the graphs draw besides the page's own.
 */
internal class SharedY(private val board: PageBoard, private val range: VisibleRange, private val compared: () -> List<ComparedLog>) {
    private val curves = HashMap<GraphSeries, Curve>()
    private val columns = PixelColumns(COLUMNS)
    private var curvesOf: Pair<BoardLines, List<ComparedLog>>? = null
    private var seenOf: Pair<Board, Span>? = null

    /** The visible values of each unit. */
    var seen: Map<String, SeenOfUnit> = emptyMap()
        private set
        get() {
            val now = board.now to range.now
            val logs = board.lines to compared()
            if (now != seenOf || logs != curvesOf) {
                seenOf = now
                if (logs != curvesOf) curves.clear()
                curvesOf = logs
                val names = board.now.graphs.filter { it.sharesY }.flatMap { it.lines - it.hidden }.distinct()
                field = seenTogether(names.flatMap { name -> (listOf(board.lines[name]) + logs.second.map { it[name] }).mapNotNull(::see) })
            }
            return field
        }

    private fun see(line: GraphSeries?): SeenOfUnit? {
        if (line == null || line.states != null) return null
        val curve = curves.getOrPut(line) { Curve(line.data, line.holdsUntil) }
        curve.draw(range.now.from, range.now.to, columns)
        return SeenOfUnit(unitText(line.unit), curve.min, curve.max)
    }

    private companion object {
        const val COLUMNS = 500
    }
}
