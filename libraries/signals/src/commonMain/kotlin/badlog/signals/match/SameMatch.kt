package badlog.signals.match

/**
 * Returns whether this and [other] are the same match. False if their types or numbers contradict each other, null if that is unknown.
 *
 * Since 2023, the matches of a playoff form one sequence: robots and Driver Stations number them, and names call the fifth `sf5m1`. Before,
 * that was the first match of the fifth pair, which the field numbered differently.
 */
internal fun MatchOfLog.isSameAs(other: MatchOfLog): Boolean? {
    val (one, two) = listOf(this, other).map { match -> match.type?.let { MatchType.of(it) } }
    val differ = one != null && two != null && one != two
    val arePlayoffs = one in PLAYOFFS && two in PLAYOFFS
    // A log may call a semifinal an elimination, but never a final a semifinal.
    if (differ && !(arePlayoffs && (one in COUNTED || two in COUNTED))) return false
    val (own, others) = (number ?: return null) to (other.number ?: return null)
    // A playoff goes on counting in its finals; until 2022, it counted quarterfinals in another order.
    if (differ && (one in RECOUNTED || two in RECOUNTED)) return null
    // Each event counts its own matches.
    if (own == others) return if (areOtherEvents(event, other.event)) null else true
    val isNumberedDifferently = arePlayoffs && ('-' in own) != ('-' in others)
    if (!isNumberedDifferently) return false
    return if (own.removeSuffix("-1") == others.removeSuffix("-1")) true else null
}

/** Whether both are codes of events, or both names, and not the same. One may be the code of the other. */
private fun areOtherEvents(one: String?, other: String?): Boolean {
    if (one == null || other == null) return false
    val (own, others) = listOf(one, other).map { it.trim().lowercase().replace(YEAR, "") }
    return own != others && (' ' in own) == (' ' in others)
}

private val YEAR = Regex("^20\\d\\d")

/** Types that count all matches of a playoff in one row. */
private val COUNTED = setOf(MatchType.ELIMINATION, MatchType.PLAYOFF)

/** Types that count their own matches. */
private val RECOUNTED = setOf(MatchType.QUARTERFINAL, MatchType.FINAL)
private val PLAYOFFS = setOf(MatchType.QUARTERFINAL, MatchType.SEMIFINAL, MatchType.FINAL, MatchType.ELIMINATION, MatchType.PLAYOFF)
