package badlog.page.view

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Curve
import badlog.viewer.text.unitText

/** What is visible in all graphs of [board] that share their y limits, on the screen or not. */
internal class SharedY(private val board: PageBoard, private val range: VisibleRange) {
    private var lines: BoardLines? = null
    private val curves = HashMap<String, Curve>()
    private val columns = PixelColumns(COLUMNS)
    private var seenOf: Pair<Board, Span>? = null
    private var seen = emptyMap<String, SeenOfUnit>()

    /** Returns what is currently visible of [unit]; null for nothing. */
    fun seen(unit: String): SeenOfUnit? {
        val now = board.now to range.now
        if (now != seenOf || lines !== board.lines) {
            seenOf = now
            if (lines !== board.lines) curves.clear()
            lines = board.lines
            seen = seenTogether(board.now.graphs.filter { it.sharesY }.flatMap { it.lines - it.hidden }.distinct().mapNotNull(::see))
        }
        return seen[unit]
    }

    private fun see(name: String): SeenOfUnit? {
        val line = board.lines[name]?.takeIf { it.states == null } ?: return null
        val curve = curves.getOrPut(name) { Curve(line.data, if (line.holds) range.full.to else null) }
        curve.draw(range.now.from, range.now.to, columns)
        return SeenOfUnit(unitText(line.unit), curve.min, curve.max)
    }

    private companion object {
        const val COLUMNS = 500
    }
}
