package badlog.page.board

import badlog.page.dom.MenuEntry
import badlog.page.view.PageBoard
import badlog.signals.pose.Pose
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.session.GraphOffer
import badlog.viewer.session.GraphOffers

/**
 * Returns the menu entries for [graph] of [board], which [item] shows.
 *
 * [topics] is the dialog that adds topics to it; [poses] are the log's poses.
 */
internal fun boardMenu(board: PageBoard, graph: BoardGraph, item: BoardItem, topics: TopicDialog, poses: List<Pose>): List<MenuEntry> {
    val offers = GraphOffers(board.now, graph, poses)
    val numbers = item.cards.firstOrNull { !it.graph.showsStates }
    fun entries(offered: List<GraphOffer>) = offered.map { MenuEntry(it.label, it.isOn) { board.send(it.change) } }
    return buildList {
        addAll(entries(offers.moves))
        add(MenuEntry("Add topics…") { topics.open(graph.id) })
        addAll(entries(offers.additions(board.now.shortTitles).take(PageBoard.MAX_OFFERED) + listOfNotNull(offers.separation)))
        if (numbers != null) addAll(entries(offers.heights(GraphHeight.MEDIUM) + offers.planes))
        addAll(entries(offers.origins))
        if (numbers != null) addAll(entries(offers.limits(numbers.picture.axes.map { it.shown })))
        addAll(entries(listOf(offers.removal)))
    }
}
