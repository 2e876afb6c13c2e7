package badlog.page.header

import badlog.core.recording.Problem
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.panelRoom
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.viewer.panel.PanelRoom
import badlog.viewer.panel.Trouble
import badlog.viewer.panel.problemsAbove
import org.w3c.dom.HTMLElement

/** The [problems] in the file and in the page's [additions], see [problemsAbove]; hidden if there are none. */
internal class ProblemSection(private val scene: Scene, private val problems: List<Problem>, private val additions: List<Trouble>) {
    private val store get() = scene.store
    private val nodes = PartNodes(scene.palette, store::send)

    val element: HTMLElement = element("section") {
        id = "problems"
        setAttribute("aria-label", "Problems of this file")
    }

    init {
        store.onChange { if (it.unfolded != store.state.unfolded) show(panelRoom) }
        show(panelRoom)
    }

    /** Lists the problems for paper, or again for the screen. */
    fun print(isOnPaper: Boolean) = show(if (isOnPaper) PanelRoom.PAPER else panelRoom)

    private fun show(room: PanelRoom) {
        val parts = problemsAbove(problems, additions, store.state.unfolded, room)
        element.patch(nodes.of(parts))
        element.isHidden = parts.isEmpty()
    }
}
