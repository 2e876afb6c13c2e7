package badlog.viewer.catalog

import badlog.core.analysis.LogView
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsEnabled
import badlog.core.recording.Topic

/**
 * Whether there is anything to see in a file.
 *
 * @property saying the text beside a gray log; empty for others.
 */
enum class Content(val saying: String) {
    /** There is. */
    SOMETHING(""),

    /** It has none. */
    NO_SAMPLES("no samples"),

    /** No number changes, and no event is logged. */
    NOTHING_CHANGES("idle log"),

    /** It is over before anything can have happened. */
    TOO_SHORT("shorter than a second"),

    /** The robot was never enabled, and it was not a match: in a match, that would be worth seeing. */
    NEVER_ENABLED("never enabled"),

    /** It cannot be read, although its name is that of a log. */
    UNREADABLE("cannot be read"),

    /** Something else that only has the same ending as logs, such as a spreadsheet of texts; it is not listed. */
    NO_LOG(""),
}

/**
 * Returns whether there is anything to see in [view]. In doubt, there is: a change of a single number, or a single event,
 * is enough.
 *
 * @param time the topic that only has the x of each row, or null.
 * @param seconds its length, or null if unknown.
 */
fun contentOf(view: LogView, topics: List<TopicSummary>, time: Topic?, seconds: Double?): Content = when {
    view.recording.sampleCount == 0L -> Content.NO_SAMPLES
    topics.none { it.name != time?.name && changes(it) } && view.recording.topics.none(::hasNews) -> Content.NOTHING_CHANGES
    seconds != null && seconds < 1 -> Content.TOO_SHORT
    view.title == null && view.knowsEnabled && view.enabledSpans().isEmpty() -> Content.NEVER_ENABLED
    else -> Content.SOMETHING
}

private fun changes(topic: TopicSummary) = topic.statistics.count > 0 && topic.statistics.min != topic.statistics.max

/** Returns whether [topic] has an event, or a state that changes. */
private fun hasNews(topic: Topic): Boolean {
    val texts = topic.texts
    return texts.size > 0 && (texts.size < topic.counts.total || texts.dictionary.size > 1)
}
