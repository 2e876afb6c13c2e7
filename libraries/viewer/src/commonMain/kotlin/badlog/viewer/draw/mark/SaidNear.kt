package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import badlog.viewer.choices.note.Note
import kotlin.math.abs

/** The maximum distance between a cursor and a mark that it points at, as a fraction of the visible width. */
const val MARK_REACH: Double = 0.008

/** The [text] of the mark of a note or an event at [x]. */
class Said(val x: Double, val text: String)

/**
 * Returns the mark that a cursor at [x] points at in [visible]: the nearest one of [notes], otherwise of [events]; null if there is none.
 */
fun saidNear(x: Double, visible: Span, notes: List<Note>, events: EventTimeline): Said? {
    val reach = visible.width * MARK_REACH
    val note = notes.minByOrNull { abs(it.x - x) }?.takeIf { abs(it.x - x) <= reach }
    if (note != null) return Said(note.x, note.text)
    return events.nearest(x, reach)?.let { Said(it.x, it.text) }
}
