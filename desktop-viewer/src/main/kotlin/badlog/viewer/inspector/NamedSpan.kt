package badlog.viewer.inspector

import badlog.analysis.Span
import badlog.plot.cursor.Cursors
import badlog.viewer.panels.StatisticsRange
import badlog.viewer.recording.OpenRecording
import badlog.viewer.view.AxisView

/** A part of x that statistics are of, and what the window calls it. */
internal data class NamedSpan(val name: String, val span: Span)

/** The selection of [view], or else what is between both cursors, or what is visible. */
internal fun shownSpan(view: AxisView): NamedSpan = view.selection?.let { NamedSpan("Selection", it) }
    ?: view.cursors.between?.let { NamedSpan(Cursors.BETWEEN, it) }
    ?: NamedSpan("Visible range", view.viewport.visible)

/** What of [open] [range] means; null where it is not known when the robot was enabled. */
internal fun spanOf(range: StatisticsRange, open: OpenRecording, view: AxisView): NamedSpan? = when (range) {
    StatisticsRange.SHOWN -> shownSpan(view)

    StatisticsRange.ENABLED -> open.enabled.takeIf { it.isNotEmpty() }?.let { enabled ->
        NamedSpan("From first to last enabled", Span(enabled.minOf { it.span.from }, enabled.maxOf { it.span.to }))
    }

    StatisticsRange.ALL -> NamedSpan("Whole log", open.span)
}
