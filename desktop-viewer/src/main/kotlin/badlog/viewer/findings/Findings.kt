package badlog.viewer.findings

import badlog.plot.search.Query
import badlog.plot.search.findsFound
import badlog.plot.search.searchedText
import badlog.plot.timeline.FindingTimeline
import badlog.recording.Severity
import badlog.rules.Finding
import badlog.rules.SkippedRule
import badlog.rules.incident.Incident
import badlog.rules.worstFirst
import java.nio.file.Path

/**
 * What the window knows of the open recording's findings.
 *
 * @property list them; null while the rules have not been run.
 * @property selected the one that a person went to last, or null.
 * @property pointed the one under the pointer, or null.
 * @property pointedPlace where on x the pointer is on it; NaN where it points at its line in a list.
 * @property timesAsked how often a person wanted the rules to be run again.
 */
internal data class Findings(
    val list: FindingList? = null,
    val selected: Finding? = null,
    val pointed: Finding? = null,
    val pointedPlace: Double = Double.NaN,
    val timesAsked: Int = 0,
) {
    /** The names of the topics that one of them is about. */
    val topics: Set<String> get() = list?.topics.orEmpty()

    /** The one whose time is shaded in the graphs, or null. */
    val shown: Finding? get() = pointed ?: selected

    /** Knows [list]; what was selected before stays so where it was found again. */
    fun knowing(list: FindingList): Findings = copy(list = list, selected = selected?.let(list::like), pointed = pointed?.let(list::like))

    /** Knows nothing yet. */
    fun unknown(): Findings = Findings(timesAsked = timesAsked)
}

/**
 * What rules found in a recording.
 *
 * @property all the findings, the worst first, and of one severity in the order of time.
 * @property skipped the rules that were skipped for it.
 * @property rulesFile where the rules come from; null for the built-in ones.
 * @property incidents what of it belongs together, and what came first; the worst first.
 * @property trouble why a file of rules is not used, or why nothing was found out, as a sentence; null when all is well.
 */
internal class FindingList(
    found: List<Finding> = emptyList(),
    val skipped: List<SkippedRule> = emptyList(),
    val rulesFile: Path? = null,
    val trouble: String? = null,
    val incidents: List<Incident> = emptyList(),
) {
    val all: List<Finding> = found.worstFirst()

    /** The names of the topics that one of them is about. */
    val topics: Set<String> = all.flatMapTo(HashSet()) { it.evidence }

    /** They by their places on x. */
    val timeline: FindingTimeline<Finding> = FindingTimeline(all, { it.severity }, { it.places })

    /** Where the place of [finding] begins that is nearest to [x]. */
    fun placeNear(finding: Finding, x: Double): Double = timeline.places.filter { it.finding === finding }
        .minByOrNull { maxOf(it.span.from - x, x - it.span.to, 0.0) }?.span?.from ?: finding.time

    /** The severity of the worst; null when there is none. */
    val worst: Severity? = all.maxOfOrNull { it.severity }

    /** The one that says the same as [finding], of which there may be another one since the log has grown; null without any. */
    fun like(finding: Finding): Finding? = all.find { it.rule == finding.rule && it.topic == finding.topic }

    /** What a search for [text] finds of it. */
    fun foundBy(text: String): SearchedFindings {
        val query = Query(text)
        if (query.isEmpty) return SearchedFindings(incidents, all)
        return SearchedFindings(incidents.filter { query.findsFound(it.searchedText) }, all.filter { query.findsFound(it.searchedText) })
    }
}

/** The [incidents] and the [findings] that a search leaves, in their order. */
internal class SearchedFindings(val incidents: List<Incident>, val findings: List<Finding>)
