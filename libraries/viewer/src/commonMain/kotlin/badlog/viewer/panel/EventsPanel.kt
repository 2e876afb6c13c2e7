package badlog.viewer.panel

import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.countOf

/**
 * Returns the events that were [found] for a panel of their own.
 *
 * @param all the number of all events of the log.
 * @param hasTopics whether they are from several topics.
 * @param nearest the index of the event nearest to the cursor; -1 for none.
 */
fun eventsPanel(found: EventTimeline, all: Int, times: LogTimes, hasTopics: Boolean, nearest: Int): List<Part> {
    if (all == 0) return listOf(Paragraph("none", "This log has no events: no topic contains event texts.", Tone.MUTED))
    val count = Paragraph("count", countOf(found.size, all, "event"), Tone.MUTED)
    if (found.size == 0) return listOf(count, Paragraph("none", "No event matches.", Tone.MUTED))
    val rows = EventRows(found.size) { event ->
        val topic = if (hasTopics) listOf(Paragraph("topic", found.topicOf(event), Tone.MUTED)) else emptyList()
        row(found, event, times, isCurrent = event == nearest, below = topic)
    }
    return listOf(count, Rows("events", "Events", rows, current = nearest))
}

/** Returns the first [limit] of the [events] of one topic, called [name], for a place among graphs; each has a button that zooms to it. */
fun eventRows(name: String, events: EventTimeline, times: LogTimes, limit: Int): Rows {
    val rows = EventRows(minOf(limit, events.size)) { event ->
        val zoom = PlaceAction.GoTo(events.x[event], isWithSurroundings = true)
        row(events, event, times, tools = listOf(Button("Zoom in on this event", zoom, PartIcon.ZOOM)))
    }
    return Rows("event-rows", "Events of $name", rows, current = -1)
}

private fun row(
    events: EventTimeline,
    index: Int,
    times: LogTimes,
    isCurrent: Boolean = false,
    tools: List<Button> = emptyList(),
    below: List<Part> = emptyList(),
): Row {
    val x = events.x[index]
    val time = times.logged(x)
    val text = events.textOf(index)
    val go = PlaceAction.GoTo(x).takeIf { x.isFinite() }
    val line = Line(text, time, since = times.sinceEnabled(x), open = go, hint = "Move the cursor here")
    return Row(
        "event $index",
        severity = null,
        "Event at $time: $text",
        title = "",
        listOf(line),
        isCurrent = isCurrent,
        open = go,
        tools = tools,
        below = below,
    )
}

/** Rows that are made when they are drawn: a log may have a hundred thousand events. */
private class EventRows(override val size: Int, private val row: (Int) -> Row) : AbstractList<Part>() {
    override fun get(index: Int): Part = row(index)
}
