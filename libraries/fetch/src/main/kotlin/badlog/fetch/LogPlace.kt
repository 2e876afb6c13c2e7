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
        fun of(name: String, match: MatchOfLog?): LogPlace {
            val both = (match ?: MatchOfLog()).orNamed(name)
            val stem = LogName.of(name).stem
            val called = both.match?.takeIf { both.number != matchInName(name).number }?.let { "$stem $it" } ?: stem
            return LogPlace(both.event?.let(::safeName), safeName(called + name.drop(stem.length)), both.title)
        }
    }
}
