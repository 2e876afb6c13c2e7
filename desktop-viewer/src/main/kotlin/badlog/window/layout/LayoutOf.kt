package badlog.window.layout

import badlog.core.analysis.Span
import badlog.viewer.choices.comparison.Alignment
import badlog.window.compare.Comparison
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.sidebar.Panels
import java.nio.file.Path

/** Returns [span] in the form for a layout; null if an end is not finite, which JSON cannot store. */
internal fun layoutSpan(span: Span) = LayoutSpan(span.from, span.to).takeIf { it.from.isFinite() && it.to.isFinite() }

/** Returns [panels] in the form for a layout. The pit view is temporary: the next start shows the graphs. */
internal fun layoutOf(panels: Panels): LayoutPanels {
    val main = panels.main.takeUnless { it == MainView.PIT } ?: MainView.GRAPHS
    return LayoutPanels(panels.library, panels.topics, panels.inspector?.name, main.name)
}

/** Returns [comparison] in the form for a layout, with files relative to [folder]. */
internal fun layoutOf(comparison: Comparison, folder: Path?) = LayoutComparison(
    files = comparison.checked.map { pathText(it, folder) },
    alignment = comparison.offsets.alignment.layoutName,
    offsets = comparison.offsets.byHand.mapKeys { pathText(it.key, folder) },
)

/** Returns the alignment of [layout]. */
internal fun alignmentOf(layout: LayoutComparison): Alignment =
    Alignment.entries.find { it.layoutName == layout.alignment } ?: Alignment.START

/** Returns [panels] in the window's form; if their main view is unknown, it stays as in [now]. */
internal fun panelsOf(panels: LayoutPanels, now: Panels): Panels = now.copy(
    library = panels.library,
    topics = panels.topics,
    keepsTopics = false,
    inspector = panels.inspector?.let { name -> InspectorTab.entries.find { it.name == name } },
    main = MainView.entries.find { it.name == panels.main } ?: now.main,
)
