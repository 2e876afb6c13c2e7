package badlog.rules

/**
 * The rules that could not run on a log, usually because they are made for logs with other topics. Rules with a mistake are not among them.
 *
 * @property ran the number of rules that ran.
 * @property skippedCount the number of rules that could not run.
 * @property lacking the signals that are missing in the log, the most needed first; empty for a simulated robot.
 * @property simulated why the log is considered simulated; null if it is not.
 */
class NotLookedAt(val ran: Int, skipped: List<SkippedRule>) {
    private val others = skipped.filter { !it.isMistake }
    val skippedCount: Int = others.size
    val simulated: String? = others.firstNotNullOfOrNull { it.simulated }
    val lacking: List<String> = if (simulated == null) lackingIn(others) else emptyList()

    /** A sentence or two. For example: `21 rules ran; 58 could not: this log has no battery, motor output and 12 other signals.` */
    val text: String
        get() = simulated?.let { "A simulation ($it): rules about power, wear and sensors do not run. " }.orEmpty() + ranText

    private val ranText
        get() = "$ran rule${if (ran == 1) "" else "s"} ran" + when {
            skippedCount == 0 || simulated != null -> "."
            lacking.isEmpty() -> "; $skippedCount could not, since this log lacks their topics."
            else -> "; $skippedCount could not: this log has no ${listed(lacking)}."
        }
}

/** Returns the signals that were missing for the rules [skipped], the most needed first. */
fun lackingIn(skipped: List<SkippedRule>): List<String> = skipped.mapNotNull { it.lacking }.groupBy { it }.entries
    .sortedByDescending { it.value.size }.map { it.key }

/** Returns the first [most] of [signals] as a list in a sentence, with the number of the others. */
fun listed(signals: List<String>, most: Int = MAX_LISTED): String {
    val some = signals.take(most).joinToString { "“$it”" }
    val others = signals.size - most
    return if (others > 0) "$some and $others other signal${if (others == 1) "" else "s"}" else some
}

private const val MAX_LISTED = 5
