package badlog.fetch

import badlog.files.LogName
import badlog.files.safeName
import badlog.signals.match.MatchOfLog
import badlog.signals.match.matchInName

/**
 * Where a log goes in the folder of fetched logs.
 *
 * @property folder the event's folder, or null if the event is unknown.
 * @property name the file's name: the robot's own, followed by the match if it does not contain that.
 * @property title the name of the match for people, or null.
 */
internal class LogPlace private constructor(val folder: String?, val name: String, val title: String?) {
    companion object {
        /** Returns the place of a log of [match] that is called [name] on the robot. */
        fun of(name: String, match: MatchOfLog): LogPlace {
            val stem = LogName.of(name).stem
            val called = match.match?.takeIf { match.number != matchInName(name).number }?.let { "$stem $it" } ?: stem
            return LogPlace(match.event?.let(::safeName), safeName(called + name.drop(stem.length)), match.title)
        }
    }
}
