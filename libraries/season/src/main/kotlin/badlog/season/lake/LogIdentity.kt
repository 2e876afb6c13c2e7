package badlog.season.lake

import badlog.core.recording.Recording
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.START_VALUE
import badlog.signals.clock.loggedStart
import badlog.signals.match.MatchOfLog
import badlog.signals.match.dateInName
import badlog.signals.match.dateInText
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.SignalVocabulary
import java.time.LocalDateTime
import java.time.ZoneOffset

/**
 * The match and time of a log, from its values, its topics or its file's name.
 *
 * @property partition the season and the event.
 * @property match the match.
 * @property number the match's number, only the first digits of it; null if unknown.
 * @property zero the time at which its x was 0, in s since 1970; null unless a clock with UTC shows it.
 * @property start the time of its first sample, in s since 1970; null if unknown.
 */
internal class LogIdentity private constructor(
    val partition: Partition,
    val match: MatchOfLog,
    val number: Int?,
    val zero: Double?,
    val start: Double?,
) {
    companion object {
        /** Returns the identity of [recording], which was read from a file called [name], using the names in [signals]. */
        fun of(name: String, recording: Recording, signals: SignalVocabulary): LogIdentity {
            val match = signals.matchOf(recording, name)
            val clock = ClockedLog(name, recording, signals)
            val zero = if (clock.hasClock) clock.start else null
            val start = zero?.let { if (clock.first.isNaN()) it else it + clock.first } ?: loggedStart(recording)
            val second = start?.toLong() ?: recording.values.find { it.name == START_VALUE }?.let { dateInText(it.text) }
                ?: dateInName(name)?.second
            val year = second?.let { LocalDateTime.ofEpochSecond(it, 0, ZoneOffset.UTC).year }
            return LogIdentity(
                Partition(year, match.event),
                match,
                match.number?.let { NUMBER.find(it) }?.value?.toInt(),
                zero,
                start,
            )
        }

        private val NUMBER = Regex("\\d{1,9}")
    }
}
