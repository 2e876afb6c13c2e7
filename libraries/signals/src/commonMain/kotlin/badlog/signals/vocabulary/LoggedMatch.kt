package badlog.signals.vocabulary

import badlog.core.analysis.isMeant
import badlog.core.analysis.matchTitle
import badlog.core.analysis.meant
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.expression.signalOf
import badlog.expression.signals.Vocabulary

/**
 * The match that a log is of, from its values, or else from its topics. Each property is null if unknown.
 *
 * @property event the event, such as `Mill Creek Regional`.
 * @property type the type, such as `Qualification`.
 * @property number the number of the match.
 */
class LoggedMatch internal constructor(val event: String?, val type: String?, val number: String?) {
    /** Its name for people; null unless there is an event and a number. */
    val title: String? get() = matchTitle(event, type, number)
}

/** Returns the match that [recording] is of, found by this vocabulary. */
fun SignalVocabulary.matchOf(recording: Recording): LoggedMatch {
    val empty = recording.topics.filter { it.kind == TopicKind.EMPTY }.mapTo(HashSet()) { it.name }
    val topics = SignalTopics(this, Vocabulary(recording.topics.map(::signalOf)), timeTopic = null, empty)
    fun topic(signal: String) = topics.of(signal).firstOrNull()?.let { found -> recording.topics.find { it.name == found.topic } }
    fun value(signal: String): String? {
        val patterns = find(signal)?.topics.orEmpty().map { it.pattern }
        return recording.values.firstOrNull { value -> isMeant(value.text) && patterns.any { it.matches(value.name) } }?.text?.trim()
    }
    val values = recording.values
    return LoggedMatch(
        event = values.meant("event name", "event") ?: value(EVENT_NAME) ?: topic(EVENT_NAME)?.let(::lastText),
        type = values.meant("match type") ?: value(MATCH_TYPE) ?: topic(MATCH_TYPE)?.let(::typeIn),
        number = values.meant("match number", "match") ?: value(MATCH_NUMBER) ?: topic(MATCH_NUMBER)?.let(::lastNumber)?.toString(),
    )
}

/** The signals that are needed for every log, whatever the question. */
internal val OF_EVERY_LOG: Set<String>
    get() = setOf(EVENT_NAME, MATCH_TYPE, MATCH_NUMBER, ROBOT_ENABLED, ROBOT_AUTONOMOUS, ROBOT_TEST, OP_MODE)

internal const val ROBOT_ENABLED = "robot enabled"
internal const val ROBOT_AUTONOMOUS = "robot autonomous"
internal const val ROBOT_TEST = "robot test"
internal const val OP_MODE = "op mode"

private const val EVENT_NAME = "event name"
private const val MATCH_TYPE = "match type"
private const val MATCH_NUMBER = "match number"

// Until the field reports the match, robots log that it is unknown.
private fun lastText(topic: Topic): String? {
    val texts = topic.texts
    return (texts.size - 1 downTo 0).firstNotNullOfOrNull { i -> texts.dictionary[texts.ids[i]].trim().takeIf(::isMeant) }
}

private fun lastNumber(topic: Topic): Int? = topic.samples.lastOrNull { it.isFinite() && it >= 1 }?.toInt()

private fun typeIn(topic: Topic): String? = lastText(topic) ?: lastNumber(topic)?.let { TYPES.getOrNull(it - 1) }

private val TYPES = listOf("Practice", "Qualification", "Elimination")
