package badlog.viewer.findings

import badlog.report.rules.Finding

/**
 * What the window knows of the open recording's findings.
 *
 * @property list them; null while the rules have not been run.
 * @property chosen the one that a person went to last, or null.
 * @property pointed the one under the pointer, or null.
 * @property timesAsked how often a person wanted the rules to be run again.
 */
internal data class Findings(
    val list: FindingList? = null,
    val chosen: Finding? = null,
    val pointed: Finding? = null,
    val timesAsked: Int = 0,
) {
    /** The one whose time is shaded in the graphs, or null. */
    val shown: Finding? get() = pointed ?: chosen

    /** Knows [list]; what was chosen before stays so where it was found again. */
    fun knowing(list: FindingList): Findings = copy(list = list, chosen = chosen?.let(list::like), pointed = pointed?.let(list::like))

    /** Knows nothing yet. */
    fun unknown(): Findings = Findings(timesAsked = timesAsked)
}
