package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import badlog.viewer.choices.note.Note
import kotlin.math.abs

/** The maximum distance between a cursor and a mark that it points at, as a fraction of the visible width. */
const val MARK_REACH: Double = 0.008

/** The [text] of the mark of a note or an event at [x]. */
class MarkText(val x: Double, val text: String)

/**
 * Returns the mark that a cursor at [x] points at in [visible]: the nearest one of [notes], otherwise of [events]. Null if there is none.
 */
fun markNear(x: Double, visible: Span, notes: List<Note>, events: EventTimeline): MarkText? {
    val reach = visible.width * MARK_REACH
    val note = notes.minByOrNull { abs(it.x - x) }?.takeIf { abs(it.x - x) <= reach }
    if (note != null) return MarkText(note.x, note.text)
    return events.nearest(x, reach)?.let { MarkText(it.x, it.text) }
}
