package badlog.viewer.inspector

import badlog.analysis.Span
import badlog.plot.cursor.Cursors
import badlog.viewer.panels.StatisticsRange
import badlog.viewer.recording.OpenRecording
import badlog.viewer.view.AxisView

/**
 * A part of x that statistics are of, and what the window calls it.
 *
 * @property span from its begin to its end.
 * @property parts what of [span] counts; they do not touch.
 */
internal data class NamedSpan(val name: String, val span: Span, val parts: List<Span> = listOf(span)) {
    /** How long it is. */
    val width: Double get() = parts.sumOf { it.width }
}

/** The selection of [view], or else what is between both cursors, or what is visible. */
internal fun shownSpan(view: AxisView): NamedSpan = view.selection?.let { NamedSpan("Selection", it) }
    ?: view.cursors.between?.let { NamedSpan(Cursors.BETWEEN, it) }
    ?: NamedSpan("Visible range", view.viewport.visible)

/** Returns what of [open] [range] means; null where it is not known when the robot was enabled. */
internal fun spanOf(range: StatisticsRange, open: OpenRecording, view: AxisView): NamedSpan? = when (range) {
    StatisticsRange.SHOWN -> shownSpan(view)

    StatisticsRange.ENABLED -> open.enabled.takeIf { it.isNotEmpty() }?.let { enabled ->
        val parts = joined(enabled.map { it.span })
        NamedSpan("Time enabled", Span(parts.first().from, parts.last().to), parts)
    }

    StatisticsRange.ALL -> NamedSpan("Whole log", open.span)
}

/** Returns [spans] in the order of x; those that touch are one. */
private fun joined(spans: List<Span>): List<Span> = buildList {
    for (span in spans.sortedBy { it.from }) {
        val before = lastOrNull()
        if (before != null && span.from <= before.to) set(lastIndex, Span(before.from, maxOf(before.to, span.to))) else add(span)
    }
}
