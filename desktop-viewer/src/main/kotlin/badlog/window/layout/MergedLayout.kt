package badlog.window.layout

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.mergedWith
import badlog.viewer.choices.formula.keyOf
import badlog.viewer.choices.mergedWith

/**
 * Returns the merged layout of two windows on one folder: what [mine] has not changed since [before] is as in [theirs], graph by graph and
 * formula by formula; otherwise it is as in [mine]. The open log and its visible range belong together.
 *
 * @param start the graphs where a layout has none.
 */
internal fun merged(mine: Layout, before: Layout, theirs: Layout, start: Board = Board()): Layout {
    val place = if (placeIn(mine) == placeIn(before)) theirs else mine
    return Layout(
        version = mine.version,
        graphs = mergedGraphs(mine.graphs, before.graphs, theirs.graphs, start),
        recording = place.recording,
        visible = place.visible,
        selection = place.selection,
        compared = (if (mine.compared == before.compared) theirs else mine).compared,
        panels = (if (mine.panels == before.panels) theirs else mine).panels,
        overTime = (if (mine.overTime == before.overTime) theirs else mine).overTime,
        formulas = mine.formulas.mergedWith(theirs.formulas, before.formulas, key = ::keyOf),
    )
}

private fun mergedGraphs(mine: Board?, before: Board?, theirs: Board?, start: Board): Board? = when {
    mine == before -> theirs
    theirs == before -> mine
    else -> (mine ?: start).mergedWith(theirs ?: start, before ?: start)
}

private fun placeIn(layout: Layout) = listOf(layout.recording, layout.visible, layout.selection)
