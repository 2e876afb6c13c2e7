package badlog.rules

import badlog.recording.Severity

/**
 * A rule that compares the figures of a log with those of a team's others, instead of asking a condition; `docs/rules.md` says what each
 * part means.
 *
 * @property name what it is called; no two rules of a set have the same.
 * @property severity how bad it is.
 * @property group what it is about.
 * @property next what to look at next, as a sentence; empty where nobody says.
 * @property signals the signals of whose topics the figures are compared.
 * @property deviations how far a figure has to be from the median of the others, in their usual distances from it.
 * @property percent how far it has to be from it at least, in percent of it.
 * @property findings so many figures of a log are findings, the farthest.
 * @property others how many other logs have to have the figure.
 */
public class Comparison internal constructor(
    public val name: String,
    public val severity: Severity,
    public val group: String,
    public val next: String,
    internal val text: RuleText,
    internal val signals: List<String>,
    internal val deviations: Double,
    internal val percent: Double,
    internal val findings: Int,
    internal val others: Int,
) {
    internal companion object {
        /** The limits that each has. */
        val LIMITS = listOf("deviations", "percent", "findings", "others")

        /** The places that its text may have. */
        val PLACES = listOf("topic", "when", "value", "difference", "usual", "others")

        /** Of fewer nobody knows how far they usually are from each other. */
        const val FEWEST_OTHERS = 5
    }
}
