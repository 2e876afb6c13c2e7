package badlog.cli.cut

import badlog.analysis.LogView
import badlog.cli.topic.part
import badlog.cli.topic.with
import badlog.plot.Span
import badlog.recording.Recording
import badlog.recording.Topic
import badlog.recording.TopicKind

/**
 * The samples of [view], whose topics have times of their own, that lie in [spans], which ascend. A value holds until the next
 * one: where a span begins, each topic has the one it held there. Events only happen, and hold nothing.
 *
 * @throws badlog.cli.Failure when there are none.
 */
internal fun samplePart(view: LogView, spans: List<Span>): CutPart {
    val whole = view.recording
    val range = view.xAxis.range ?: throw nothingThere(view, "sample")
    val inside = intersection(spans, listOf(Span(range.start, range.endInclusive)))
    // Topics that share their times do so in the part, too.
    val holding = ClockPart.Cache(inside, holdsValues = true)
    val happening = ClockPart.Cache(inside, holdsValues = false)
    val topics = whole.topics.map { topic ->
        val times = topic.times ?: return@map topic
        val clock = (if (isEvent(topic) || topic.name == CLOCK_PAIR) happening else holding).of(times)
        topic.part(clock.indices, clock.times).let { if (isEvent(topic) && !isEvent(it)) it.with(it.attributes + EVENT_LOG) else it }
    }
    val part = Recording(whole.format, whole.headerLine, whole.values, topics, 0, whole.problems)
    if (part.sampleCount == 0L) throw nothingThere(view, "sample")
    return CutPart(part, listOf(0 until 0), inside)
}

private fun isEvent(topic: Topic) = topic.kind == TopicKind.EVENT || EVENT_LOG in topic.attributes

private const val EVENT_LOG = "log"

/** Tells the time of day at a time of the log, which is true only where it was written. */
private const val CLOCK_PAIR = "systemTime"
