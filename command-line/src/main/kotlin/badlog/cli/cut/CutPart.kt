package badlog.cli.cut

import badlog.cli.input.Failure
import badlog.cli.output.EVENT_LOG
import badlog.cli.text.XTime
import badlog.cli.topic.part
import badlog.cli.topic.with
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/**
 * The part of a log that is kept.
 *
 * @property recording the recording that contains it.
 * @property rows its rows in [recording]; if that has no rows, the part is all of it.
 * @property spans its place on the x axis.
 */
internal class CutPart(val recording: Recording, val rows: List<IntRange>, val spans: List<Span>) {
    /** The number of its rows. */
    val rowCount: Int get() = rows.sumOf { it.count() }

    /** The number of its samples. */
    val sampleCount: Long
        get() = if (recording.rowCount == 0) recording.sampleCount else rowCount.toLong() * recording.topics.size
}

/**
 * Returns the rows of [view] that lie in [spans].
 *
 * @throws Failure if there are none.
 */
internal fun rowPart(view: LogView, spans: List<Span>): CutPart {
    val x = view.xAxis.positions
    val runs = rowsIn(x, spans).runs()
    if (runs.isEmpty()) throw emptyPartFailure(view, "row")
    return CutPart(view.recording, runs, runs.map { Span(x[it.first], x[it.last]) })
}

/** Returns the failure for a requested part without any [noun] of [view]. */
internal fun emptyPartFailure(view: LogView, noun: String): Failure {
    val axis = view.xAxis
    val range = axis.range ?: return Failure("it has no ${noun}s.")
    val text = "from ${XTime.text(range.start, axis.unit)} to ${XTime.text(range.endInclusive, axis.unit)}"
    return Failure("there are no ${noun}s there; ${axis.name} goes $text.")
}

/**
 * Returns the samples of [view] in [spans], for a log in which each topic has its own times. The spans must be in ascending order. A value
 * holds until the next one: at the start of a span, each topic has the value that holds there. Events do not hold.
 *
 * @throws badlog.cli.input.Failure if there are none.
 */
internal fun samplePart(view: LogView, spans: List<Span>): CutPart {
    val whole = view.recording
    val range = view.xAxis.range ?: throw emptyPartFailure(view, "sample")
    val inside = intersection(spans, listOf(Span(range.start, range.endInclusive)))
    // Topics that share their times also share them in the part.
    val holding = ClockPart.Cache(inside, holdsValues = true)
    val happening = ClockPart.Cache(inside, holdsValues = false)
    val topics = whole.topics.map { topic ->
        val times = topic.times ?: return@map topic
        val clock = (if (isEvent(topic) || topic.name == CLOCK_PAIR) happening else holding).of(times)
        topic.part(clock.indices, clock.times).let { if (isEvent(topic) && !isEvent(it)) it.with(it.attributes + EVENT_LOG) else it }
    }
    val part = whole.copy(topics = topics, rowCount = 0)
    if (part.sampleCount == 0L) throw emptyPartFailure(view, "sample")
    return CutPart(part, listOf(0 until 0), inside)
}

private fun isEvent(topic: Topic) = topic.kind == TopicKind.EVENT || EVENT_LOG in topic.attributes

/** The entry with the time of day, which is only correct at its original time. */
private const val CLOCK_PAIR = "systemTime"
