package badlog.viewer.layout

import badlog.analysis.Span
import badlog.viewer.app.Viewer
import badlog.viewer.compare.Alignment
import badlog.viewer.graph.GraphList
import badlog.viewer.graph.GraphSpec
import badlog.viewer.graph.standardGraphs
import badlog.viewer.panels.Panels
import java.nio.file.Files

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

/** What lies over the open recording now, as a layout keeps it. */
internal fun comparisonOf(viewer: Viewer): LayoutComparison {
    val folder = viewer.library.folder
    val comparison = viewer.comparison
    return LayoutComparison(
        files = comparison.ticked.map { pathText(it, folder) },
        alignment = comparison.alignment.name,
        offsets = comparison.handOffsets.mapKeys { pathText(it.key, folder) },
    )
}

/** Lays over the open recording what [compared] names, as it was aligned; files that are gone are left out. */
internal fun restoreComparison(viewer: Viewer, compared: LayoutComparison) {
    val folder = viewer.library.folder
    fun fileOf(text: String) = pathOf(text, folder)?.toAbsolutePath()?.normalize()
    val files = compared.files.mapNotNull(::fileOf).distinct().filter(Files::isRegularFile)
    val offsets = compared.offsets.entries.mapNotNull { (text, offset) -> fileOf(text)?.let { it to offset } }
    viewer.comparison.ticked.filter { it !in files }.forEach(viewer.comparisonLoading::remove)
    files.filter { it !in viewer.comparison.ticked }.forEach(viewer.comparisonLoading::add)
    viewer.comparison = viewer.comparison.copy(
        alignment = Alignment.entries.find { it.name == compared.alignment } ?: Alignment.START,
        handOffsets = offsets.toMap(),
    )
}
