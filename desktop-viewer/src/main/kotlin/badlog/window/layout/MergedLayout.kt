package badlog.window.layout

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.mergedWith
import badlog.viewer.choices.formula.keyOf
import badlog.viewer.choices.mergedWith

/**
 * Returns the merged layout of two windows on one folder. Each graph and formula that [mine] has not changed since [before] is as in
 * [theirs]; otherwise it is as in [mine]. The open log and its visible range belong together. Graphs do not draw formulas that one of the
 * two has removed.
 *
 * @param initial the graphs that [mine] began with, if [before] has none.
 */
internal fun merged(mine: Layout, before: Layout, theirs: Layout, initial: Board = Board()): Layout {
    val place = if (placeIn(mine) == placeIn(before)) theirs else mine
    val both = Layout(
        version = mine.version,
        graphs = mergedGraphs(mine.graphs, before.graphs, theirs.graphs, initial),
        recording = place.recording,
        visible = place.visible,
        selection = place.selection,
        place = place.place,
        compared = (if (mine.compared == before.compared) theirs else mine).compared,
        panels = (if (mine.panels == before.panels) theirs else mine).panels,
        overTime = (if (mine.overTime == before.overTime) theirs else mine).overTime,
        formulas = mine.formulas.mergedWith(theirs.formulas, before.formulas, key = ::keyOf),
    )
    val removed = listOf(mine, before, theirs).flatMapTo(HashSet()) { it.formulas.map(::keyOf) } - both.formulas.map(::keyOf).toSet()
    return both.copy(graphs = both.graphs?.let { removed.fold(it, Board::withoutSignal) })
}

private fun mergedGraphs(mine: Board?, before: Board?, theirs: Board?, initial: Board): Board? = when {
    mine == before -> theirs
    theirs == before || mine == null || theirs == null -> mine
    else -> mine.mergedWith(theirs, before ?: initial)
}

private fun placeIn(layout: Layout) = listOf(layout.recording, layout.visible, layout.selection, layout.place)
