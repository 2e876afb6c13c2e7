package badlog.viewer.shown.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.NotLookedAt
import badlog.rules.SkippedRule
import badlog.rules.incident.Incident
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.shown.search.Query

/**
 * The findings of a log, and the facts about the rules.
 *
 * @param found the findings.
 * @property skipped the rules that did not run.
 * @property incidents the groups of related findings, each with its order; the worst group first.
 * @property ran the number of rules that ran; null while they run, or if they could not. In that case, all of [found] come from sources
 *   other than rules.
 * @property rules the name of the file with the rules; null for the built-in ones.
 * @property trouble the reason why a file of rules is not used, or the rules could not run, as a sentence; null if there is no such
 *   problem.
 */
class RuleResults(
    found: List<Finding> = emptyList(),
    val skipped: List<SkippedRule> = emptyList(),
    val incidents: List<Incident> = emptyList(),
    val ran: Int? = null,
    val rules: String? = null,
    val trouble: String? = null,
) {
    /** The findings by their places on x. */
    val timeline: FindingTimeline<Finding> = FindingTimeline(found, { it.severity }, { it.places })

    /** The findings, the worst first, and within a severity in the order of x. */
    val all: List<Finding> get() = timeline.worstFirst

    private val search = FindingSearch(all, incidents)
    private val ofIncidents: Map<Finding, Incident> by lazy {
        // A finding of several incidents belongs to the worst.
        incidents.asReversed().flatMap { incident -> (incident.causes + incident.effects).map { it to incident } }.toMap()
    }
    private var last: Pair<String, SearchedFindings>? = null

    /** A summary of the skipped rules and their missing signals; null until the rules have run. */
    val notLookedAt: NotLookedAt? = ran?.let { NotLookedAt(it, skipped) }

    /** The names of the topics that the findings are about. */
    val topics: Set<String> = all.flatMapTo(HashSet()) { it.evidence }

    /** The order in which keys go through the findings. */
    val order: FindingOrder by lazy { FindingOrder(timeline, incidents) }

    /** The severity of the worst finding; null if there is none. */
    val worst: Severity? get() = all.maxOfOrNull { it.severity }

    /** Returns the incident of [finding]; null if there is none. */
    fun incidentOf(finding: Finding): Incident? = ofIncidents[finding]

    /** Returns the finding that corresponds to [finding], which may be a new object because the log has grown. Null if there is none. */
    fun like(finding: Finding): Finding? = all.find { it.rule == finding.rule && it.topic == finding.topic }

    /** Returns the findings that match a search for [text]. */
    fun foundBy(text: String): SearchedFindings =
        last?.takeIf { it.first == text }?.second ?: search.foundBy(Query(text)).also { last = text to it }
}
