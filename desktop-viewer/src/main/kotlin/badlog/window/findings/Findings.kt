package badlog.window.findings

import badlog.rules.Finding
import badlog.viewer.shown.finding.FoundInLog

/**
 * What the window knows about the open recording's findings.
 *
 * @property list the findings; null until the rules have run.
 * @property pointed the one under the pointer, or null.
 * @property pointedPlace where on x the pointer is on it; NaN if it is on its line in a list.
 * @property timesAsked how often a person requested to run the rules again.
 */
internal data class Findings(
    val list: FoundInLog? = null,
    val pointed: Finding? = null,
    val pointedPlace: Double = Double.NaN,
    val timesAsked: Int = 0,
) {
    /** The names of the topics that a finding is about. */
    val topics: Set<String> get() = list?.topics.orEmpty()

    /** Returns the findings with [list]. */
    fun knowing(list: FoundInLog): Findings = copy(list = list, pointed = pointed?.let(list::like))

    /** Returns the findings without a list. */
    fun unknown(): Findings = Findings(timesAsked = timesAsked)
}
