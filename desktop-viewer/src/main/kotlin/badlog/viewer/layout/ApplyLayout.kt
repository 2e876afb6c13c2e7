package badlog.viewer.layout

import badlog.plot.formula.joined
import badlog.viewer.app.Viewer
import badlog.viewer.formula.takeFormulas
import badlog.viewer.graph.standardGraphs
import badlog.viewer.panels.InspectorTab
import badlog.viewer.panels.MainView
import badlog.viewer.panels.Panels

/**
 * Arranges the window as [layout] says, as far as the open recording has what it names; what is left out is said. Its formulas
 * are added to those that there are.
 */
internal fun applyLayout(viewer: Viewer, layout: Layout) {
    layout.panels?.let { viewer.panels = panelsOf(it, viewer.panels) }
    takeFormulas(viewer, joined(viewer.formulas, layout.formulas))
    restoreComparison(viewer, layout.compared)
    applyGraphs(viewer, layout)
    applyPlace(viewer, layout)
}

/** Shows the graphs of [layout], as far as the open recording has them; what is left out is said. */
internal fun applyGraphs(viewer: Viewer, layout: Layout) {
    val open = viewer.open ?: return
    val graphs = layout.graphs
    if (graphs == null) {
        viewer.graphs = standardGraphs(open.logged)
        return
    }
    val fitted = fitted(graphs, open)
    viewer.graphs = fitted.graphs
    fitted.sentence?.let(viewer.notices::say)
}

/** Shows the part of x that [layout] shows, and marks what it marks; where the recording has neither, all of it is shown. */
internal fun applyPlace(viewer: Viewer, layout: Layout) {
    if (viewer.open == null) return
    val full = viewer.viewport.full
    val visible = layout.visible?.let(::spanOf)?.takeIf { it.from < full.to && it.to > full.from }
    viewer.viewport = if (visible == null) viewer.viewport.reset() else viewer.viewport.showing(visible.from, visible.to)
    viewer.selection = layout.selection?.let(::spanOf)
}

/** Shows the graphs that the attributes of the open recording's topics ask for, all of x, and nothing over it. */
internal fun showStandardGraphs(viewer: Viewer) {
    val open = viewer.open ?: return
    viewer.graphs = standardGraphs(open.logged)
    viewer.viewport = viewer.viewport.reset()
}

/** [panels] as the window knows them; what this program does not know stays as in [now]. */
internal fun panelsOf(panels: LayoutPanels, now: Panels): Panels = now.copy(
    library = panels.library,
    topics = panels.topics,
    inspector = panels.inspector?.let { name -> InspectorTab.entries.find { it.name == name } },
    main = MainView.entries.find { it.name == panels.main } ?: now.main,
)
