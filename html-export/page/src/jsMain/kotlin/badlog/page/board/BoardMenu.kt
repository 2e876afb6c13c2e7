package badlog.page.board

import badlog.core.analysis.Span
import badlog.page.dom.MenuEntry
import badlog.page.view.PageBoard
import badlog.signals.pose.Pose
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.canSwapAxes
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.draw.path.xyLabelOf

/**
 * Returns the menu entries for [graph], one of those of [board], which [item] shows; [topics] can be added to it. The log has these
 * [poses].
 */
internal fun boardMenu(board: PageBoard, graph: BoardGraph, item: BoardItem, topics: TopicDialog, poses: List<Pose>): List<MenuEntry> {
    val id = graph.id
    val others = board.now.run { graphs.zip(shortTitles) }.filter { (other, _) -> other.id != id }
    val place = board.now.graphs.indexOfFirst { it.id == id }
    val numbers = item.cards.firstOrNull { !it.graph.showsStates }
    val isFixed = graph.yRange != null || graph.rightYRange != null
    return buildList {
        if (place > 1) add(MenuEntry("Move to the top") { board.change { moved(id, -place) } })
        if (place > 0) add(MenuEntry("Move up") { board.change { moved(id, -1) } })
        if (place < others.size) add(MenuEntry("Move down") { board.change { moved(id, 1) } })
        add(MenuEntry("Add topics…") { topics.open(id) })
        for ((other, title) in others.take(PageBoard.MOST_OFFERED)) {
            add(MenuEntry("Add to “$title”") { board.change { joined(other.id, id) } })
        }
        if (graph.lines.size > 1) add(MenuEntry("A graph for each line") { board.change { separated(id) } })
        if (numbers != null) {
            for (height in GraphHeight.entries) {
                val label = "Height: ${height.label.lowercase()}"
                add(MenuEntry(label, GraphHeight.of(graph.height) == height) { board.change { resized(id, height.pixels) } })
            }
            if (graph.lines.size > 1) {
                add(MenuEntry(xyLabelOf(graph.lines, poses), graph.isXy) { board.change { withXy(id, !graph.isXy) } })
                if (graph.canSwapAxes(poses)) add(MenuEntry("Swap axes") { board.change { withSwappedAxes(id) } })
            }
        }
        if (graph.isXy && poses.any { it.x in graph.lines }) {
            for (origin in FieldOrigin.entries) {
                add(MenuEntry(origin.label, graph.origin == origin) { board.change { withOrigin(id, origin) } })
            }
        }
        if (numbers != null && !graph.isXy) {
            add(
                MenuEntry("Fix the y limits", isFixed) {
                    if (isFixed) board.change { withYRange(id, null) } else numbers.showY(Span(0.0, 1.0))
                },
            )
            add(MenuEntry("Share the y limits", graph.sharesY) { board.change { withSharedY(id, !graph.sharesY) } })
        }
        add(MenuEntry("Remove this graph") { board.change { without(id) } })
    }
}
