package badlog.viewer.shown.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.NotLookedAt
import badlog.rules.SkippedRule
import badlog.rules.incident.Incident
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.shown.search.Query

/**
 * What is known of a log's findings.
 *
 * @param found the findings.
 * @property skipped the rules that did not run.
 * @property incidents which findings belong together, and what came first; the worst first.
 * @property ran how many rules ran; null while they run or if they could not, so that [found] are others' findings alone.
 * @property rules the name of the file that the rules come from; null for the built-in ones.
 * @property trouble why a file of rules is not used, or the rules could not run, as a sentence; null if all is well.
 */
class FoundInLog(
    found: List<Finding> = emptyList(),
    val skipped: List<SkippedRule> = emptyList(),
    val incidents: List<Incident> = emptyList(),
    val ran: Int? = null,
    val rules: String? = null,
    val trouble: String? = null,
) {
    /** The findings by their places on x. */
    val timeline: FindingTimeline<Finding> = FindingTimeline(found, { it.severity }, { it.places })

    /** The findings, the worst first, and of one severity in the order of x. */
    val all: List<Finding> get() = timeline.worstFirst

    private val search = FindingSearch(all, incidents)
    private val ofIncidents: Map<Finding, Incident> by lazy {
        // A finding of several belongs to the worst.
        incidents.asReversed().flatMap { incident -> (incident.causes + incident.effects).map { it to incident } }.toMap()
    }
    private var last: Pair<String, SearchedFindings>? = null

    /** What could not be looked at; null until the rules have run. */
    val notLookedAt: NotLookedAt? = ran?.let { NotLookedAt(it, skipped) }

    /** The names of the topics that the findings are about. */
    val topics: Set<String> = all.flatMapTo(HashSet()) { it.evidence }

    /** The order in which keys go through the findings. */
    val order: FindingOrder by lazy { FindingOrder(timeline, incidents) }

    /** The severity of the worst finding; null when there is none. */
    val worst: Severity? get() = all.maxOfOrNull { it.severity }

    /** Returns the incident that [finding] is part of; null for none. */
    fun incidentOf(finding: Finding): Incident? = ofIncidents[finding]

    /** Returns the finding that corresponds to [finding], which may be a new object because the log has grown; null for none. */
    fun like(finding: Finding): Finding? = all.find { it.rule == finding.rule && it.topic == finding.topic }

    /** Returns what a search for [text] finds. */
    fun foundBy(text: String): SearchedFindings =
        last?.takeIf { it.first == text }?.second ?: search.foundBy(Query(text)).also { last = text to it }
}
