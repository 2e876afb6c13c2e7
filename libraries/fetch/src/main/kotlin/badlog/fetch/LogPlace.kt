package badlog.fetch

import badlog.files.LogName
import badlog.files.safeName
import badlog.signals.match.MatchOfLog
import badlog.signals.match.dateInName
import badlog.signals.match.matchInName
import java.time.LocalDateTime
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter

/**
 * The place of a log in the folder of fetched logs.
 *
 * @property folder the event's folder, or null if the event is unknown.
 * @property name the file's name: its name on the robot, followed by the match if it does not contain that. If the match is unknown and the
 * name has no date, the start of the log follows if it is known.
 * @property title the title of the match, or null.
 */
internal class LogPlace private constructor(val folder: String?, val name: String, val title: String?) {
    companion object {
        /**
         * Returns the place of a log of [match], called [name] on the robot. [start] is its start in s since 1970; null if it is unknown.
         */
        fun of(name: String, match: MatchOfLog, start: Long?): LogPlace {
            val stem = LogName.of(name).stem
            val called = when {
                match.match == null -> if (start == null || dateInName(name) != null) stem else "$stem ${dateText(start)}"
                match.number == matchInName(name).number -> stem
                else -> "$stem ${match.match}"
            }
            return LogPlace(match.event?.let(::safeName), safeName(called + name.drop(stem.length)), match.title)
        }

        private fun dateText(second: Long) = DATE.format(LocalDateTime.ofEpochSecond(second, 0, ZoneOffset.UTC))

        private val DATE = DateTimeFormatter.ofPattern("uuuu-MM-dd HH-mm")
    }
}
