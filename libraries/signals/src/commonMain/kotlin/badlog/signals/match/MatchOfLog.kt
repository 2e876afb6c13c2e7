package badlog.signals.match

import badlog.core.analysis.firstText
import badlog.core.analysis.isMeaningful
import badlog.core.analysis.matchTitle
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.expression.signalOf
import badlog.expression.signals.Vocabulary
import badlog.signals.vocabulary.EVENT_NAME
import badlog.signals.vocabulary.MATCH_NUMBER
import badlog.signals.vocabulary.MATCH_TYPE
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.topicsWithoutValues

/**
 * The match in which a log was recorded. Each property is null if unknown.
 *
 * @property event the event, such as `Mill Creek Regional`.
 * @property type the type, such as `Qualification`.
 * @property number the number of the match; usually digits, but `2-1` for the first match of the second semifinal.
 * @property alliance `Red` or `Blue` if it can be recognized, otherwise as logged.
 */
data class MatchOfLog(val event: String? = null, val type: String? = null, val number: String? = null, val alliance: String? = null) {
    /** The match within its event: `Qualification 42`; null without a number. */
    val match: String? get() = number?.let { "${type ?: "Match"} $it" }

    /** Its name for people, with the event; null unless there is an event or a number. */
    val title: String? get() = matchTitle(event, type, number)

    /** The kind of run. */
    val kind: MatchKind get() = type?.let { MatchType.of(it) }?.kind ?: MatchKind.UNKNOWN

    /**
     * Returns a copy that takes unknown properties from [named], the match in the file's name. The type is taken only if the numbers do not
     * differ; the alliance never is.
     */
    internal fun or(named: MatchOfLog) = MatchOfLog(
        event = event ?: named.event,
        type = type ?: named.type.takeIf { number == null || number == named.number },
        number = number ?: named.number,
        alliance = alliance,
    )

    companion object {
        /** The red [alliance]. */
        const val RED: String = "Red"

        /** The blue [alliance]. */
        const val BLUE: String = "Blue"
    }
}

/**
 * Returns the match of [recording]. It is read from the recording's values, otherwise from its topics, found by this vocabulary, otherwise
 * from [fileName], the name of its file.
 */
fun SignalVocabulary.matchOf(recording: Recording, fileName: String): MatchOfLog {
    val topics = SignalTopics(this, Vocabulary(recording.topics.map(::signalOf)), timeTopic = null, topicsWithoutValues(recording.topics))
    fun topic(signal: String) = topics.of(signal).firstOrNull()?.let { found -> recording.topics.find { it.name == found.topic } }
    fun value(signal: String): String? {
        val patterns = find(signal)?.topics.orEmpty().map { it.pattern }
        return recording.values.firstOrNull { value -> isMeaningful(value.text) && patterns.any { it.matches(value.name) } }?.text?.trim()
    }
    val values = recording.values
    val logged = MatchOfLog(
        event = values.firstText("event name", "event") ?: value(EVENT_NAME) ?: topic(EVENT_NAME)?.let(::lastText),
        type = values.firstText("match type") ?: value(MATCH_TYPE) ?: topic(MATCH_TYPE)?.let(::typeIn),
        number = values.firstText("match number", "match") ?: value(MATCH_NUMBER) ?: topic(MATCH_NUMBER)?.let(::lastNumber)?.toString(),
        alliance = allianceIn(values),
    )
    return logged.or(matchInName(fileName))
}

/**
 * Returns the alliance in the header [values] of a log. It is `Red` or `Blue` if it can be recognized, otherwise as logged; null if none
 * has it.
 */
fun allianceIn(values: List<Value>): String? {
    val text = values.firstText("alliance", "alliance color", "alliance colour", "alliance station") ?: return null
    return listOf(MatchOfLog.RED, MatchOfLog.BLUE).find { text.startsWith(it, ignoreCase = true) } ?: text
}

// Until the field reports the match, robots log that it is unknown.
private fun lastText(topic: Topic): String? {
    val texts = topic.texts
    return (texts.size - 1 downTo 0).firstNotNullOfOrNull { i -> texts.dictionary[texts.ids[i]].trim().takeIf(::isMeaningful) }
}

private fun lastNumber(topic: Topic): Int? = topic.samples.lastOrNull { it.isFinite() && it >= 1 }?.toInt()

private fun typeIn(topic: Topic): String? = lastText(topic) ?: lastNumber(topic)?.let { NUMBERED.getOrNull(it - 1)?.title }

/** The types that WPILib logs as the numbers 1, 2 and 3. */
private val NUMBERED = listOf(MatchType.PRACTICE, MatchType.QUALIFICATION, MatchType.ELIMINATION)
