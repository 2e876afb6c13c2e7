package badlog.viewer.draw.mark

import badlog.core.analysis.Event
import badlog.core.analysis.EventLog
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.stableOrder
import badlog.core.text.isLetterOrDigit
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import kotlin.math.abs
import kotlin.math.floor

/**
 * Events of several topics in the order of x, without an object for each. Events without an x come last. At the same x, events of an
 * earlier log come first, and events of one log keep their order.
 *
 * @property x the x of each event; NaN where the x axis has a gap. Must not be changed.
 */
class EventTimeline private constructor(
    val x: DoubleArray,
    private val logs: List<EventLog>,
    private val logOf: IntArray,
    private val cells: IntArray,
) {
    val size: Int get() = x.size

    /** The number of events with an x; these events come first. */
    val placedCount: Int = x.size - x.count { it.isNaN() }

    private val places = x.copyOf(placedCount).let { Series(it, it) }

    /** For each event with an x, the number of errors and warnings before it, and at the end their total. */
    private val seriousBefore by lazy {
        // Each different text is examined once, however often it was logged.
        val areSerious = logs.map { log -> BooleanArray(log.topic.texts.dictionary.size) { isSerious(log.topic.texts.dictionary[it]) } }
        val counts = IntArray(placedCount + 1)
        for (i in 0 until placedCount) counts[i + 1] = counts[i] + if (areSerious[logOf[i]][idOf(i)]) 1 else 0
        counts
    }

    /** Returns event [index] as a new object. */
    fun eventAt(index: Int): Event = logs[logOf[index]].events[cells[index]]

    /** Returns the text of event [index]. */
    fun textOf(index: Int): String = logs[logOf[index]].topic.texts[cells[index]]

    /** Returns the full name of the topic of event [index]. */
    fun topicOf(index: Int): String = logs[logOf[index]].name

    /** Returns the index of the first event at or after [position]; [placedCount] if there is none. */
    fun firstAtOrAfter(position: Double): Int = places.firstAtOrAfter(position)

    /** Returns the index of the event nearest to [position]; -1 if none has an x. */
    fun nearest(position: Double): Int = places.nearest(position)

    /** Returns the event nearest to [position] if it is at most [distance] away, otherwise null. */
    fun nearest(position: Double, distance: Double): Event? =
        nearest(position).takeIf { it >= 0 && abs(x[it] - position) <= distance }?.let(::eventAt)

    /** Returns the last event at or before [position]; null if there is none. */
    fun lastBefore(position: Double): Event? = (places.firstAfter(position) - 1).takeIf { it >= 0 }?.let(::eventAt)

    /** Returns whether an event from index [from] until [until] says that it is an error or a warning. These events must have an x. */
    internal fun areSerious(from: Int, until: Int): Boolean = seriousBefore[until] > seriousBefore[from]

    /**
     * Returns the events with a text or topic that matches [query]. They are limited to the topics called [topics], unless that is empty.
     */
    fun matching(query: Query, topics: Set<String> = emptySet()): EventTimeline {
        if (query.isEmpty && topics.isEmpty()) return this
        val fits = logs.map { log ->
            val isWanted = topics.isEmpty() || log.name in topics
            val texts = log.topic.texts.dictionary
            BooleanArray(texts.size) { isWanted && query.matches("${log.name} ${texts[it]}", EVENT) }
        }
        val kept = IntArray(size)
        var count = 0
        for (i in 0 until size) if (fits[logOf[i]][idOf(i)]) kept[count++] = i
        return EventTimeline(
            DoubleArray(count) { x[kept[it]] },
            logs,
            IntArray(count) { logOf[kept[it]] },
            IntArray(count) { cells[kept[it]] },
        )
    }

    private fun idOf(index: Int) = logs[logOf[index]].topic.texts.ids[cells[index]]

    companion object {
        val NONE: EventTimeline = of(emptyList())

        /** Returns the events of all [logs]. */
        fun of(logs: List<EventLog>): EventTimeline {
            val count = logs.sumOf { it.topic.texts.size }
            val x = DoubleArray(count)
            val logOf = IntArray(count)
            val cells = IntArray(count)
            var next = 0
            logs.forEachIndexed { log, events ->
                for (cell in 0 until events.topic.texts.size) {
                    val place = events.events[cell].x
                    x[next] = if (place.isFinite()) place else Double.NaN
                    logOf[next] = log
                    cells[next++] = cell
                }
            }
            val order = stableOrder(x)
            return EventTimeline(
                DoubleArray(count) { x[order[it]] },
                logs,
                IntArray(count) { logOf[order[it]] },
                IntArray(count) { cells[order[it]] },
            )
        }
    }
}

/** Returns whether [text] says that it is an error or a warning, as in `ERROR: brownout` or `[warning] …`. */
private fun isSerious(text: String): Boolean {
    var start = 0
    while (start < text.length && !isLetterOrDigit(text[start]) && text[start] != '_') start++
    return SERIOUS.any { text.startsWith(it, start, ignoreCase = true) }
}

private val EVENT = setOf(Trait.EVENT)
private val SERIOUS = listOf("error", "warn", "fatal", "severe", "critical")

/**
 * The marks of events on a time line, each for one or more events that share a pixel. A mark is a head with a line below it, or a tick for
 * events that crowd behind another one, so that a chatty robot does not hide its graphs. Errors and warnings always have heads. The arrays
 * are reused for the next drawing.
 */
class EventMarks {
    private var pixels = DoubleArray(0)
    private var looks = IntArray(0)

    var size: Int = 0
        private set

    /** Returns the place of mark [index], in pixels from the left. */
    fun pixelOf(index: Int): Double = pixels[index]

    /** Returns whether one of the events of mark [index] is an error or a warning. */
    fun isSerious(index: Int): Boolean = looks[index] and SERIOUS != 0

    /** Returns whether mark [index] has a head; otherwise it is a tick. */
    fun hasHead(index: Int): Boolean = looks[index] and HEAD != 0

    /** Returns whether a line runs down from mark [index]. */
    fun hasLine(index: Int): Boolean = looks[index] and LINE != 0

    /**
     * Finds the marks of the [events] in [span], over [width] physical pixels; a CSS pixel or dp is [onePixel] of them. The cost depends on
     * the number of pixels, not of events.
     */
    fun place(events: EventTimeline, span: Span, width: Double, onePixel: Double) {
        size = 0
        val columns = floor(width / onePixel)
        if (!(columns >= 1) || !(span.width > 0)) return
        var index = events.firstAtOrAfter(span.from)
        while (index < events.placedCount && events.x[index] <= span.to) {
            val column = floor((events.x[index] - span.from) / span.width * columns)
            val next = maxOf(index + 1, minOf(events.firstAtOrAfter(span.from + (column + 1) * span.width / columns), events.placedCount))
            val until = if (column >= columns) events.placedCount else next
            add(column * onePixel, events.areSerious(index, until))
            index = until
        }
        look(APART * onePixel)
    }

    private fun add(pixel: Double, isSerious: Boolean) {
        // Because of rounding, the next event may be in this pixel again.
        val isSame = size > 0 && pixels[size - 1] == pixel
        if (!isSame && size++ == pixels.size) {
            pixels = pixels.copyOf(maxOf(FIRST_MARKS, size * 2))
            looks = looks.copyOf(pixels.size)
        }
        pixels[size - 1] = pixel
        looks[size - 1] = (if (isSame) looks[size - 1] else 0) or if (isSerious) SERIOUS else 0
    }

    private fun look(apart: Double) {
        var lastLine = Double.NEGATIVE_INFINITY
        for (i in 0 until size) {
            val isCrowded = (i > 0 && pixels[i] - pixels[i - 1] < apart) ||
                (i + 1 < size && isSerious(i + 1) && pixels[i + 1] - pixels[i] < apart)
            if (isSerious(i) || !isCrowded) looks[i] = looks[i] or HEAD
            if (if (isSerious(i)) pixels[i] - lastLine >= apart else !isCrowded) {
                looks[i] = looks[i] or LINE
                lastLine = pixels[i]
            }
        }
    }

    private companion object {
        const val SERIOUS = 1
        const val HEAD = 2
        const val LINE = 4

        /** The minimum distance between two heads or lines, in CSS pixels or dp. */
        const val APART = 9
        const val FIRST_MARKS = 64
    }
}
