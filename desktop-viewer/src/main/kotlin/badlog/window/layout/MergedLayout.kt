package badlog.window.layout

import badlog.viewer.choices.formula.keyOf
import badlog.viewer.choices.mergedWith

/**
 * Returns the merged layout of two windows on one folder: what [mine] has not changed since [before] is as in [theirs], formula by
 * formula; otherwise it is as in [mine]. The open log and its visible range belong together.
 */
internal fun merged(mine: Layout, before: Layout, theirs: Layout): Layout {
    val place = if (placeIn(mine) == placeIn(before)) theirs else mine
    return Layout(
        version = mine.version,
        graphs = (if (mine.graphs == before.graphs) theirs else mine).graphs,
        recording = place.recording,
        visible = place.visible,
        selection = place.selection,
        compared = (if (mine.compared == before.compared) theirs else mine).compared,
        panels = (if (mine.panels == before.panels) theirs else mine).panels,
        overTime = (if (mine.overTime == before.overTime) theirs else mine).overTime,
        formulas = mine.formulas.mergedWith(theirs.formulas, before.formulas, key = ::keyOf),
    )
}

private fun placeIn(layout: Layout) = listOf(layout.recording, layout.visible, layout.selection)
