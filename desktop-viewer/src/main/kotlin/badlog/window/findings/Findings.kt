package badlog.window.findings

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.NotLookedAt
import badlog.rules.SkippedRule
import badlog.rules.incident.Incident
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.shown.finding.FindingOrder
import badlog.viewer.shown.finding.FindingSearch
import badlog.viewer.shown.finding.SearchedFindings
import badlog.viewer.shown.search.Query
import java.nio.file.Path

/**
 * What the window knows about the open recording's findings.
 *
 * @property list the findings; null until the rules have run.
 * @property pointed the one under the pointer, or null.
 * @property pointedPlace where on x the pointer is on it; NaN if it is on its line in a list.
 * @property timesAsked how often a person requested to run the rules again.
 * @property refusal why a topic was not assigned to a signal, as a sentence; null if nothing was refused.
 */
internal data class Findings(
    val list: FindingList? = null,
    val pointed: Finding? = null,
    val pointedPlace: Double = Double.NaN,
    val timesAsked: Int = 0,
    val refusal: String? = null,
) {
    /** The names of the topics that one of them is about. */
    val topics: Set<String> get() = list?.topics.orEmpty()

    /** Returns the findings with [list]. */
    fun knowing(list: FindingList): Findings = copy(list = list, pointed = pointed?.let(list::like))

    /** Returns the findings without a list. */
    fun unknown(): Findings = Findings(timesAsked = timesAsked)
}

/**
 * What rules found in a recording.
 *
 * @property all the findings, the worst first, and of one severity in the order of x.
 * @property skipped the rules that were skipped for it.
 * @property rulesFile where the rules come from; null for the built-in ones.
 * @property incidents which of them belong together, and what came first; the worst first.
 * @param ran how many rules were not skipped.
 * @property trouble why a file of rules is not used, or the rules could not run, as a sentence; null if all is well.
 */
internal class FindingList(
    found: List<Finding> = emptyList(),
    val skipped: List<SkippedRule> = emptyList(),
    val rulesFile: Path? = null,
    val trouble: String? = null,
    val incidents: List<Incident> = emptyList(),
    ran: Int = 0,
) {
    /** What could not be looked at, as a sentence. */
    val notLookedAt: String = NotLookedAt(ran, skipped).text

    /** The signals that most rules lack, which a topic can be assigned to. */
    val lacking: List<String> = NotLookedAt(ran, skipped).lacking.take(MOST_LACKING)

    /** The findings by their places on x. */
    val timeline: FindingTimeline<Finding> = FindingTimeline(found, { it.severity }, { it.places })

    val all: List<Finding> get() = timeline.worstFirst

    private val search = FindingSearch(all, incidents)

    /** The names of the topics that one of them is about. */
    val topics: Set<String> = all.flatMapTo(HashSet()) { it.evidence }

    /** The order in which keys go through them. */
    val order: FindingOrder by lazy { FindingOrder(timeline, incidents) }

    /** Returns the start of the place of [finding] nearest to [x]. */
    fun placeNear(finding: Finding, x: Double): Double = timeline.places.filter { it.finding === finding }
        .minByOrNull { maxOf(it.span.from - x, x - it.span.to, 0.0) }?.span?.from ?: finding.time

    /** The severity of the worst; null when there is none. */
    val worst: Severity? = all.maxOfOrNull { it.severity }

    /** Returns the finding that corresponds to [finding], which may be a new object because the log has grown; null for none. */
    fun like(finding: Finding): Finding? = all.find { it.rule == finding.rule && it.topic == finding.topic }

    /** Returns what a search for [text] finds in it. */
    fun foundBy(text: String): SearchedFindings = search.foundBy(Query(text))
}

/** As many as a person assigns at a time. */
private const val MOST_LACKING = 5
