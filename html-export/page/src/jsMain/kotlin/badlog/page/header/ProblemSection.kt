package badlog.page.header

import badlog.core.recording.Problem
import badlog.core.recording.Severity
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.panelRoom
import badlog.page.embedded.GivenLayout
import badlog.page.formula.Formulas
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.protocol.PageAdditions
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

/**
 * Returns all problems with [additions], [layout], and the definitions of [formulas]; the recording itself is complete. [additions] is null
 * if the additions cannot be read.
 */
internal fun additionProblems(formulas: Formulas, additions: PageAdditions?, layout: GivenLayout): List<Trouble> {
    val problems = ArrayList<Trouble>()
    fun add(message: String, pointer: String = "") {
        problems += Trouble("addition ${problems.size}", Severity.WARNING, message, pointer)
    }
    if (additions == null) {
        add("This browser cannot read the findings and calculations in this page; try another one.")
    }
    layout.problem?.let { add(it) }
    for (error in formulas.errors) {
        val kind = if (error.text in formulas.own) "Your formula" else "A formula of this page"
        add("$kind cannot be calculated: ${error.message}", error.pointed().substringAfter('\n'))
    }
    additions?.rulesProblem?.let { problem ->
        add(problem.substringBefore('\n'), problem.substringAfter('\n', ""))
    }
    additions?.notesProblem?.let { add(it) }
    for (hook in additions?.hooks.orEmpty()) {
        if (hook.error != null) add("The hook ${hook.name} failed: ${hook.error}")
    }
    return problems
}
