package badlog.window.sidebar

import badlog.core.analysis.Span
import badlog.viewer.shown.cursor.Cursors
import badlog.window.log.AxisView
import badlog.window.log.OpenRecording

/**
 * A part of x for statistics, and its label in the window.
 *
 * @property span from its start to its end.
 * @property parts the parts of [span] that count; they do not touch.
 */
internal data class NamedSpan(val name: String, val span: Span, val parts: List<Span> = listOf(span)) {
    /** Its length. */
    val width: Double get() = parts.sumOf { it.width }
}

/** Returns the selection of [view], otherwise the range between both cursors, otherwise the visible range. */
internal fun shownSpan(view: AxisView): NamedSpan = view.selection?.let { NamedSpan("Selection", it) }
    ?: view.cursors.between?.let { NamedSpan(Cursors.BETWEEN, it) }
    ?: NamedSpan("Visible range", view.viewport.visible)

/** Returns the part of [open] that [range] selects; null if that requires enabled times, and they are unknown. */
internal fun spanOf(range: StatisticsRange, open: OpenRecording, view: AxisView): NamedSpan? = when (range) {
    StatisticsRange.SHOWN -> shownSpan(view)

    StatisticsRange.ENABLED -> open.enabled.takeIf { it.isNotEmpty() }?.let { enabled ->
        val parts = joined(enabled.map { it.span })
        NamedSpan("Time enabled", Span(parts.first().from, parts.last().to), parts)
    }

    StatisticsRange.ALL -> NamedSpan("Whole log", open.span)
}

/** Returns [spans] in the order of x; those that touch are joined. */
private fun joined(spans: List<Span>): List<Span> = buildList {
    for (span in spans.sortedBy { it.from }) {
        val before = lastOrNull()
        if (before != null && span.from <= before.to) set(lastIndex, Span(before.from, maxOf(before.to, span.to))) else add(span)
    }
}
