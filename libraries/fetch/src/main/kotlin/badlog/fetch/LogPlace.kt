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
 * Where a log goes in the folder of fetched logs.
 *
 * @property folder the event's folder, or null if the event is unknown.
 * @property name the file's name: the robot's own, followed by the match if it does not contain that; if there is neither a match nor a
 *   date in it, by when the log began.
 * @property title the name of the match for people, or null.
 */
internal class LogPlace private constructor(val folder: String?, val name: String, val title: String?) {
    companion object {
        /** Returns the place of a log of [match] that is called [name] on the robot, and began at [start], in s since 1970, if that is known. */
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
