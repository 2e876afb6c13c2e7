package badlog.viewer.draw.figure

import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.draw.mark.Clocks
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.cursorText
import badlog.viewer.text.differenceText
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import badlog.viewer.text.word

/**
 * The texts of an exported figure besides its graphs, which make it self-explanatory.
 *
 * @property place the file, the visible range and the cursors' places, in one line.
 * @property findings the findings in that range, the worst first, at most [MAX_NAMED].
 * @property moreFindings the number of further findings in that range.
 */
class FigureNotes private constructor(val place: String, val findings: List<NamedFinding>, val moreFindings: Int) {
    companion object {
        /** The maximum number of findings with their texts: more would take more room than the graphs. */
        const val MAX_NAMED: Int = 8

        /**
         * Returns the notes of a figure of [visible] on [axis]. [fileName] is empty if the title already has it; [found] is null if the
         * findings are unknown.
         */
        fun of(
            fileName: String,
            axis: XAxis,
            visible: Span,
            cursors: Cursors,
            clocks: Clocks,
            found: FindingTimeline<Finding>?,
        ): FigureNotes {
            fun at(x: Double) = placeText(x, axis, visible.width)
            val second = cursors.second
            val place = listOfNotNull(
                fileName.ifEmpty { null },
                "${at(visible.from)} – ${withUnit(at(visible.to), axis.unit)}",
                cursors.x?.let { "cursor at ${cursorText(it, axis, visible.width, clocks.textAt(it))}" },
                second?.let { "B at ${withUnit(at(it), axis.unit)}, ${differenceText(cursors.x ?: it, it, axis)}" },
            ).joinToString(" · ")
            val seen = found?.worstFirst.orEmpty().mapNotNull { finding ->
                val span = finding.places.firstOrNull { it.from <= visible.to && it.to >= visible.from } ?: return@mapNotNull null
                val head = "${finding.severity.word} · ${withUnit(at(span.from), axis.unit)}"
                NamedFinding(finding.severity, head, "${finding.rule}: ${finding.textAt(span)}")
            }
            return FigureNotes(place, seen.take(MAX_NAMED), maxOf(0, seen.size - MAX_NAMED))
        }
    }
}

/**
 * A finding in a figure.
 *
 * @property head the severity and the first place in the visible range: `error · 93.71 s`.
 * @property text the rule, and its finding at that place.
 */
class NamedFinding internal constructor(val severity: Severity, val head: String, val text: String)
