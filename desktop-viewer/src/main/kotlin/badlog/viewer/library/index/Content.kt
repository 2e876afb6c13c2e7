package badlog.viewer.library.index

import badlog.analysis.LogView
import badlog.analysis.enabledSpans
import badlog.analysis.knowsEnabled
import badlog.recording.Topic

/**
 * Whether there is anything to see in a file.
 *
 * @property saying what stands beside a log that is grayed; empty for one that is not.
 */
internal enum class Content(val saying: String) {
    /** There is. */
    SOMETHING(""),

    /** It has none. */
    NO_SAMPLES("no samples"),

    /** No number changes and no event is logged. */
    NOTHING_CHANGES("idle log"),

    /** It is over before anything can have happened. */
    TOO_SHORT("shorter than a second"),

    /** The robot was off duty all the time, and it was not a match: in a match, that it never moved is the story. */
    NEVER_ENABLED("never enabled"),

    /** It cannot be read though its name says that it is a log. */
    UNREADABLE("cannot be read"),

    /** Something else that only shares its ending with logs, such as a spreadsheet of texts; it is not listed. */
    NO_LOG(""),
}

/**
 * Returns whether there is anything to see in [view]. Only what surely is nothing counts as nothing: a change of a single
 * number, or a single event, is something.
 *
 * @param time the topic that only shows where on x a row stands, or null.
 * @param seconds how long it is, or null where it is unknown.
 */
internal fun contentOf(view: LogView, topics: List<TopicSummary>, time: Topic?, seconds: Double?): Content = when {
    view.recording.sampleCount == 0L -> Content.NO_SAMPLES
    topics.none { it.name != time?.name && changes(it) } && view.recording.topics.none(::hasNews) -> Content.NOTHING_CHANGES
    seconds != null && seconds < 1 -> Content.TOO_SHORT
    view.title == null && view.knowsEnabled && view.enabledSpans().isEmpty() -> Content.NEVER_ENABLED
    else -> Content.SOMETHING
}

private fun changes(topic: TopicSummary) = topic.statistics.count > 0 && topic.statistics.min != topic.statistics.max

/** An event is news, and so is a state that becomes another. */
private fun hasNews(topic: Topic): Boolean {
    val texts = topic.texts
    return texts.size > 0 && (texts.size < topic.counts.total || texts.dictionary.size > 1)
}
