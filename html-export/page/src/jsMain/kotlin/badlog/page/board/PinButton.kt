package badlog.page.board

import badlog.page.dom.Icon
import badlog.page.dom.addIconButton
import badlog.page.view.PageBoard
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.state.GraphChange
import org.w3c.dom.HTMLElement

/** Adds a button that puts [graph] on [board] or removes it. The graph need not be drawn. */
internal fun HTMLElement.addPin(board: PageBoard, graph: BoardGraph): HTMLElement =
    addIconButton("pin", Icon.PIN, "Keep ${graph.title} on the board") { board.send(GraphChange.Toggle(graph)) }.also { button ->
        fun update() = button.setAttribute("aria-pressed", board.now.has(graph).toString())
        board.onChange(::update)
        update()
    }
