package badlog.window.findings

import badlog.rules.Finding
import badlog.viewer.shown.finding.RuleResults

/**
 * The state of the open recording's findings.
 *
 * @property list the findings; null until the rules have run.
 * @property pointed the finding under the pointer, or null.
 * @property pointedPlace the x of the pointer on the finding's mark; NaN if the pointer is on its line in a list.
 * @property timesAsked the number of a person's requests to run the rules again.
 */
internal data class Findings(
    val list: RuleResults? = null,
    val pointed: Finding? = null,
    val pointedPlace: Double = Double.NaN,
    val timesAsked: Int = 0,
) {
    /** The names of the topics that a finding is about. */
    val topics: Set<String> get() = list?.topics.orEmpty()

    /** Returns the findings with [list]. */
    fun withList(list: RuleResults): Findings = copy(list = list, pointed = pointed?.let(list::like))

    /** Returns the findings without a list. */
    fun unknown(): Findings = Findings(timesAsked = timesAsked)
}
