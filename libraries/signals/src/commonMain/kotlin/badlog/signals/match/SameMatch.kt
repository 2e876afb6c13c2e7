package badlog.signals.match

/**
 * Returns whether this and [other] are one match, by what the logs say: false if their types or numbers contradict each other, null if
 * they leave it open.
 *
 * Since 2023, a playoff has one row of matches: robots and Driver Stations count them, and names call the fifth `sf5m1`. Before, that was
 * the first match of the fifth pair, which the field counted otherwise.
 */
internal fun MatchOfLog.isSameAs(other: MatchOfLog): Boolean? {
    val (one, two) = listOf(this, other).map { match -> match.type?.let { MatchType.of(it) } }
    val arePlayoffs = one in PLAYOFFS && two in PLAYOFFS
    // A log may call a semifinal an elimination.
    if (one != null && two != null && one != two && !arePlayoffs) return false
    val (own, others) = (number ?: return null) to (other.number ?: return null)
    if (own == others) return true
    val isCountedOtherwise = arePlayoffs && ('-' in own) != ('-' in others)
    if (!isCountedOtherwise) return false
    return if (own.removeSuffix("-1") == others.removeSuffix("-1")) true else null
}

private val PLAYOFFS = setOf(MatchType.QUARTERFINAL, MatchType.SEMIFINAL, MatchType.FINAL, MatchType.ELIMINATION, MatchType.PLAYOFF)
