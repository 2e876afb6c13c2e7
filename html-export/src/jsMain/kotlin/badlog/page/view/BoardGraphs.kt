package badlog.page.view

import badlog.analysis.Graph
import badlog.analysis.LogView
import badlog.plot.board.BoardGraph

/** What [spec] shows of [view], which has at least one of its lines. */
internal fun graphOf(spec: BoardGraph, view: LogView): Graph {
    val topics = view.recording.topics.associateBy { it.name }
    val lines = spec.lines.mapNotNull { name -> topics[name]?.let(view::seriesOf) }
    return Graph(spec.title, lines[0].unit, isVirtual = false, spec.isFilled, spec.includesZero, lines)
}
