package badlog.viewer.layout

import badlog.plot.Span
import badlog.viewer.app.Panels
import badlog.viewer.app.Viewer
import badlog.viewer.graph.GraphList
import badlog.viewer.graph.GraphSpec
import badlog.viewer.graph.standardGraphs

/** How the window is arranged now. */
internal fun layoutOf(viewer: Viewer): Layout {
    val open = viewer.open
    val isStandard = open == null || hasSameGraphs(viewer.graphs, standardGraphs(open.logged))
    return Layout(
        version = Layout.VERSION,
        graphs = if (isStandard) null else layoutGraphs(viewer.graphs),
        recording = open?.let { pathText(it.file, viewer.library.folder) },
        visible = viewer.viewport.visible.takeIf { viewer.viewport.isZoomed }?.let(::layoutSpan),
        selection = viewer.selection?.let(::layoutSpan),
        compared = comparisonOf(viewer),
        panels = layoutPanels(viewer.panels),
        formulas = viewer.formulas,
    )
}

/** Whether [one] and [other] show the same, whatever the ids. */
internal fun hasSameGraphs(one: GraphList, other: GraphList): Boolean = layoutGraphs(one) == layoutGraphs(other)

/** [graphs] as a layout keeps them. */
internal fun layoutGraphs(graphs: GraphList): List<LayoutGraph> = graphs.graphs.map(::layoutGraph)

private fun layoutGraph(graph: GraphSpec) = LayoutGraph(
    title = graph.title,
    lines = graph.lines.map { it.signal },
    filled = graph.isFilled,
    zero = graph.includesZero,
    y = graph.yRange?.let(::layoutSpan),
)

// JSON has no numbers that are not finite.
private fun layoutSpan(span: Span) = LayoutSpan(span.from, span.to).takeIf { it.from.isFinite() && it.to.isFinite() }

private fun layoutPanels(panels: Panels) = LayoutPanels(panels.library, panels.topics, panels.inspector?.name, panels.main.name)
