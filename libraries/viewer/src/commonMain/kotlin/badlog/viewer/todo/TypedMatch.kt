package badlog.viewer.todo

import badlog.signals.match.MatchOfLog
import badlog.signals.match.NaturalOrder
import badlog.signals.match.dateInName
import badlog.signals.match.matchInName
import kotlin.math.abs

/** The words before the last match, if the next one is unknown. */
internal const val AFTER = "the match after "

/** The words for the next match if no match was played yet. */
const val UNNAMED_MATCH: String = "the next match"

/**
 * Returns a [typed] match, such as `q58` or `58`, as logs name it: `Qualification 58`. Other texts stay as they are.
 *
 * @param last the match that was played last, which provides the type for a number alone; null if unknown.
 */
fun matchText(typed: String, last: MatchOfLog? = null): String {
    val text = typed.trim()
    val type = if (last == null) "Qualification" else last.type ?: "Match"
    val (word, first, second) = TYPED_MATCH.matchEntire(text)?.destructured ?: return text
    val number = if (second.isEmpty()) first else "$first-$second"
    if (word.isEmpty()) return "$type $number"
    val named = matchInName("$word $first")
    return if (named.number == null) text else "${named.type ?: type} $number"
}

private val TYPED_MATCH = Regex("([A-Za-z]*)[-_. #]*0*([0-9]{1,3})(?:(?:-|-?[mM])0*([0-9]{1,2}))?")

/**
 * Returns whether [log] was recorded after this change.
 *
 * Of matches of the same type at the same event, the one with the higher number is later. A repair before Qualification 58 has not failed
 * in Qualification 57, although that log may come late. Otherwise the logs' clocks decide, if they can be compared.
 *
 * @param before the match before which it was done; null if not given.
 */
internal fun TodoChange.isBefore(log: TodoLog, before: String?): Boolean {
    val clock = seen ?: dateInName(time)?.second ?: return false
    val isSameEvent = event != null && event == log.match.event
    // Without the name of an event, a log from days before may belong to another event.
    val isNear = isSameEvent || !log.isDated || (abs(log.second - clock) <= LONGEST_EVENT && !(event == null && clock - log.second > DAY))
    val order = if (before == null || !isNear) null else orderOf(log, before)
    return order ?: (log.isDated && log.second > clock)
}

/** Returns whether [log] is of [match] or of a later one of its type; null if they cannot be compared. */
private fun TodoChange.orderOf(log: TodoLog, match: String): Boolean? {
    val name = match.removePrefix(AFTER)
    val (type, number) = name.substringBeforeLast(' ', "") to name.substringAfterLast(' ')
    val own = log.match.number?.takeIf { (log.match.type ?: "Match") == type } ?: return null
    if (event != null && log.match.event != null && event != log.match.event) return null
    val order = NaturalOrder.compare(own, number)
    return if (name == match) order >= 0 else order > 0
}

/** The maximum length of an event, in s. */
internal const val LONGEST_EVENT = 5 * 86_400L
private const val DAY = 86_400L
