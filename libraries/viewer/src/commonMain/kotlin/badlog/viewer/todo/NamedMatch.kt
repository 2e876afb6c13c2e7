package badlog.viewer.todo

import badlog.signals.match.NaturalOrder
import badlog.signals.match.dateInName
import badlog.signals.match.matchInName
import kotlin.math.abs

/** The words before the last match, where the next one is not known. */
internal const val AFTER = "the match after "

/** The words for the next match if no match was played yet. */
const val SOME_MATCH: String = "the next match"

/** Returns what a person typed as a match, such as `q58`, as logs name it: `Qualification 58`; other texts stay as they are. */
fun matchText(typed: String): String = typed.trim().let { text -> matchInName(text).match?.takeIf { ' ' !in text } ?: text }

/**
 * Returns whether [log] was recorded after this change.
 *
 * Of matches of the same type, the one with the higher number is later: what was done before Qualification 58 has not failed in
 * Qualification 57, although its log may come late. Everything else is as the logs' clocks say.
 *
 * @param before the match before which it was done; null if not given.
 */
internal fun TodoChange.isBefore(log: FoundLog, before: String?): Boolean {
    val clock = seen ?: dateInName(time)?.second ?: return false
    val order = if (before == null || abs(log.second - clock) > LONGEST_EVENT) null else orderOf(log, before)
    return order ?: (log.second > clock)
}

/** Returns whether [log] is of [match] or of a later one of its type; null if they cannot be compared. */
private fun TodoChange.orderOf(log: FoundLog, match: String): Boolean? {
    val name = match.removePrefix(AFTER)
    val (type, number) = name.substringBeforeLast(' ', "") to name.substringAfterLast(' ')
    val own = log.match.number?.takeIf { log.match.type == type } ?: return null
    if (event != null && log.match.event != null && event != log.match.event) return null
    val order = NaturalOrder.compare(own, number)
    return if (name == match) order >= 0 else order > 0
}

/** In s. */
private const val LONGEST_EVENT = 5 * 86_400L
