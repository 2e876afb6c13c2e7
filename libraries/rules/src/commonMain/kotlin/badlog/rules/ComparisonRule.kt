package badlog.rules

import badlog.core.recording.Severity
import badlog.rules.standing.PROVEN_TRUST

/**
 * A rule that compares the numbers of a log with the team's other logs, instead of evaluating a condition. `docs/rules.md` explains each part.
 *
 * @property name its name, unique in a set of rules.
 * @property severity how serious it is.
 * @property group its subject.
 * @property next the next step, as a sentence; empty if not given.
 * @property signals the names of the signals with the numbers to compare.
 * @property deviations the minimum distance of a number from the median of the others, in multiples of their usual distance from it.
 * @property percent the minimum distance from the median, in percent of it.
 * @property findings the maximum number of findings in a log, the farthest numbers first.
 * @property others the minimum number of other logs that a number is compared with.
 * @property trust how far its findings can be relied on, from 0 to [PROVEN_TRUST].
 */
class ComparisonRule internal constructor(
    val name: String,
    val severity: Severity,
    val group: String,
    val next: String,
    internal val text: RuleText,
    internal val signals: List<String>,
    internal val deviations: Double,
    internal val percent: Double,
    internal val findings: Int,
    internal val others: Int,
    val trust: Double = PROVEN_TRUST,
) {
    internal companion object {
        /** The limits that each comparison has. */
        val LIMITS = listOf("deviations", "percent", "findings", "others")

        /** The placeholders that its text may have. */
        val PLACES = listOf("topic", "when", "value", "difference", "usual", "others")

        /** The lowest number of other logs that a rule may ask for. With fewer, the usual distance is unknown. */
        const val MIN_OTHERS = 5
    }
}
