package badlog.fetch

import badlog.core.analysis.matchTitle
import badlog.files.LogName
import badlog.files.matchInName
import badlog.files.safeName
import badlog.signals.vocabulary.LoggedMatch

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
        fun of(name: String, match: LoggedMatch?): LogPlace {
            val named = matchInName(name)
            val event = match?.event ?: named.event
            val number = match?.number ?: named.number
            val type = match?.type ?: named.type.takeIf { number == named.number }
            val stem = LogName.of(name).stem
            val called = if (number == null || number == named.number) stem else "$stem ${type ?: "Match"} $number"
            return LogPlace(event?.let(::safeName), safeName(called + name.drop(stem.length)), matchTitle(event, type, number))
        }
    }
}
