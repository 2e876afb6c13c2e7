package badlog.viewer.catalog

import badlog.core.analysis.LogView
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsEnabled
import badlog.core.recording.Topic

/**
 * Whether a file has anything to see, or the reason why not.
 *
 * @property saying the text beside a gray log; empty if the log is not gray, or not listed.
 */
enum class Content(val saying: String) {
    /** The file has something to see. */
    SOMETHING(""),

    /** The log has no samples. */
    NO_SAMPLES("no samples"),

    /** No number changes, and no event is logged. */
    NOTHING_CHANGES("idle log"),

    /** The log is too short for anything to happen. */
    TOO_SHORT("shorter than a second"),

    /** The robot was never enabled, and the log does not name a match. A match in which it was never enabled would be worth seeing. */
    NEVER_ENABLED("never enabled"),

    /** The file cannot be read, although its name belongs to a log. */
    UNREADABLE("cannot be read"),

    /** The file has the extension of a log but is something else, such as a spreadsheet of texts. It is not listed. */
    NO_LOG(""),
}

/**
 * Returns whether [view] has anything to see, or the reason why not. A change of a single number, or a single event, is enough.
 *
 * @param time the topic that only has the x of each row, or null.
 * @param seconds the length of the log, or null if unknown.
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
