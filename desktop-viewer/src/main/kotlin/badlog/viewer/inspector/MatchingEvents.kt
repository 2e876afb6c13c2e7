package badlog.viewer.inspector

import badlog.analysis.Event
import badlog.analysis.EventLog
import badlog.analysis.Series
import badlog.plot.Span
import kotlin.math.abs

/**
 * Events of several topics in the order of x, without an object for each. Those without an x come last.
 *
 * @property x where each stands; NaN where the x axis has a gap. Not to be changed.
 * @property logs the event logs they come from.
 * @property logOf for each event the place of its log in [logs]. Not to be changed.
 * @property placedCount how many have an x; they are the first ones.
 */
internal class MatchingEvents(val x: DoubleArray, val logs: List<EventLog>, val logOf: IntArray, private val cells: IntArray) {
    /** How many there are. */
    val size: Int get() = x.size

    val placedCount: Int = x.size - x.count { it.isNaN() }

    private val places = Series(x.copyOf(placedCount), DoubleArray(placedCount))

    /** Event [index], made anew. */
    fun eventAt(index: Int): Event = logs[logOf[index]].events[cells[index]]

    /** The text of event [index]. */
    fun textOf(index: Int): String = logs[logOf[index]].topic.texts[cells[index]]

    /** The full name of the topic of event [index]. */
    fun topicOf(index: Int): String = logs[logOf[index]].name

    /** The first event at or after [position]; [placedCount] when there is none. */
    fun firstAtOrAfter(position: Double): Int = places.firstAtOrAfter(position)

    /** The event nearest to [position]; -1 when none has an x. */
    fun nearest(position: Double): Int = places.nearest(position)

    /** The event nearest to [position] if it is no further than [distance], else null. */
    fun nearest(position: Double, distance: Double): Event? =
        nearest(position).takeIf { it >= 0 && abs(x[it] - position) <= distance }?.let(::eventAt)

    /**
     * The pixels, ascending, of [width] that show [span], on which events stand. Costs as much as there are pixels, however many
     * events there are.
     */
    fun pixels(span: Span, width: Int): IntArray {
        val pixels = IntArray(minOf(width + 1, placedCount))
        var count = 0
        var index = firstAtOrAfter(span.from)
        while (index < placedCount && x[index] <= span.to && count < pixels.size) {
            val pixel = ((x[index] - span.from) / span.width * width).toInt()
            // What was skipped to may be this pixel again, by rounding.
            if (count == 0 || pixels[count - 1] != pixel) pixels[count++] = pixel
            index = maxOf(index + 1, firstAtOrAfter(span.from + (pixel + 1) * span.width / width))
        }
        return pixels.copyOf(count)
    }

    /** Those that [keep] wants, by their index. */
    fun filtered(keep: (Int) -> Boolean): MatchingEvents {
        val kept = IntArray(size)
        var count = 0
        for (i in 0 until size) if (keep(i)) kept[count++] = i
        if (count == size) return this
        return MatchingEvents(
            DoubleArray(count) { x[kept[it]] },
            logs,
            IntArray(count) { logOf[kept[it]] },
            IntArray(count) { cells[kept[it]] },
        )
    }

    /** Which cell of its topic's texts event [index] is. */
    internal fun cellOf(index: Int): Int = cells[index]

    companion object {
        /** No events. */
        val NONE = MatchingEvents(DoubleArray(0), emptyList(), IntArray(0), IntArray(0))
    }
}
