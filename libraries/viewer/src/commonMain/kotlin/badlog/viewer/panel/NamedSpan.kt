package badlog.viewer.panel

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Place
import badlog.viewer.state.StatisticsRange
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit

/**
 * A part of x for statistics, and its label.
 *
 * @property span from its start to its end.
 * @property parts the parts of [span] that count; they do not touch.
 */
data class NamedSpan(val name: String, val span: Span, val parts: List<Span> = listOf(span)) {
    /** Returns its label, its length, and its ends on [axis]: `Selection: 2.5 s (1.25 – 3.75 s)`. */
    fun text(axis: XAxis): String {
        val (from, to) = listOf(span.from, span.to).map { placeText(it, axis, span.width) }
        return "$name: ${withUnit(placeText(parts.sumOf { it.width }, axis, span.width), axis.unit)} ($from – ${withUnit(to, axis.unit)})"
    }
}

/** Returns the selection at this place, otherwise the range between both cursors, otherwise the visible range. */
val Place.measured: NamedSpan
    get() = selection?.let { NamedSpan("Selection", it) }
        ?: cursors.between?.let { NamedSpan(Cursors.BETWEEN, it) }
        ?: NamedSpan("Visible range", range.visible)

/** Returns the part of the log that [wanted] selects at this place. [enabled] is the time when the robot was enabled; empty if unknown. */
fun Place.spanOf(wanted: StatisticsRange, enabled: List<EnabledSpan>): NamedSpan = when (wanted) {
    StatisticsRange.ENABLED -> joined(enabled.map { it.span }).let { parts ->
        if (parts.isEmpty()) measured else NamedSpan("Time enabled", Span(parts.first().from, parts.last().to), parts)
    }

    StatisticsRange.SHOWN -> measured

    StatisticsRange.ALL -> NamedSpan("Whole log", range.full)
}

/** Returns [spans] in the order of x; those that touch are joined. */
private fun joined(spans: List<Span>): List<Span> = buildList {
    for (span in spans.sortedBy { it.from }) {
        val before = lastOrNull()
        if (before != null && span.from <= before.to) set(lastIndex, Span(before.from, maxOf(before.to, span.to))) else add(span)
    }
}
