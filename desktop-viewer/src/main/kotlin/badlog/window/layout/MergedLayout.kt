package badlog.window.layout

/**
 * Returns the merged layout of two windows on one folder: what [mine] has not changed since [before] is as in [theirs], formula by
 * formula; otherwise it is as in [mine]. The open log and its visible range belong together.
 */
internal fun merged(mine: Layout, before: Layout, theirs: Layout): Layout {
    val place = if (placeIn(mine) == placeIn(before)) theirs else mine
    val gone = before.formulas.toSet() - theirs.formulas.toSet()
    return Layout(
        version = mine.version,
        graphs = (if (mine.graphs == before.graphs) theirs else mine).graphs,
        recording = place.recording,
        visible = place.visible,
        selection = place.selection,
        compared = (if (mine.compared == before.compared) theirs else mine).compared,
        panels = (if (mine.panels == before.panels) theirs else mine).panels,
        overTime = (if (mine.overTime == before.overTime) theirs else mine).overTime,
        formulas = (mine.formulas - gone + (theirs.formulas - before.formulas.toSet())).distinct(),
    )
}

private fun placeIn(layout: Layout) = listOf(layout.recording, layout.visible, layout.selection)
