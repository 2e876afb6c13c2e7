package badlog.page.graph

import badlog.page.dom.Icon
import badlog.page.dom.MenuEntry
import badlog.page.dom.addIconButton
import badlog.page.dom.openMenu
import badlog.page.view.PageBoard
import badlog.page.view.Scene
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.state.GraphChange
import org.w3c.dom.HTMLElement

/**
 * The buttons among [tools] that put a graph on the board, on its own or into another graph.
 *
 * @param look returns the graph with its current settings.
 */
internal class BoardButtons(tools: HTMLElement, private val scene: Scene, private val look: () -> BoardGraph) {
    private val add: HTMLElement = tools.addIconButton("add-to-graph", Icon.PLUS, "Add to graph…") { offerGraphs() }
        .apply { setAttribute("aria-haspopup", "menu") }
    private val pin: HTMLElement = tools.addIconButton("pin", Icon.PIN, "Keep on the board (P)") { togglePin() }

    /** Puts the graph on the board, or removes it. */
    fun togglePin() = scene.store.send(GraphChange.Toggle(look()))

    /** Shows whether the graph is on the board. */
    fun update() = pin.setAttribute("aria-pressed", scene.board.now.has(look()).toString())

    /** Lists the graphs of the board to which this one can be added. */
    private fun offerGraphs() {
        val titled = scene.board.now.run { graphs.zip(shortTitles) }
        val graphs = titled.filterNot { (other, _) -> other.lines.containsAll(look().lines) }.take(PageBoard.MAX_OFFERED)
        if (graphs.isEmpty()) return scene.notice.say("The board has no other graph to add this to; keep one on it first.")
        val entries = graphs.map { (other, title) ->
            MenuEntry("Add to “$title”") { scene.store.send(GraphChange.AddLines(other.id, look().lines)) }
        }
        openMenu(add, add.closest(".graph")?.parentElement.unsafeCast<HTMLElement>(), entries)
    }
}
