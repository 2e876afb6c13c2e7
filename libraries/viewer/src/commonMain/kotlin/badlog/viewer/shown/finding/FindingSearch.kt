package badlog.viewer.shown.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countText
import badlog.viewer.text.word

/**
 * The findings in a log, for a search. The searched texts are made at the first search.
 *
 * @property all the findings, the worst first.
 * @property incidents the incidents among them, the worst first.
 */
class FindingSearch(val all: List<Finding>, val incidents: List<Incident>) {
    private val texts by lazy { all.map { it.searchedText } }
    private val textsOfIncidents by lazy { incidents.map { it.searchedText } }

    /** Returns the findings and incidents that match [query], in the same order; all of them for an empty query. */
    fun foundBy(query: Query): SearchedFindings {
        if (query.isEmpty) return SearchedFindings(this, all, incidents)
        return SearchedFindings(
            this,
            all.filterIndexed { i, _ -> query.findsFound(texts[i]) },
            incidents.filterIndexed { i, _ -> query.findsFound(textsOfIncidents[i]) },
        )
    }
}

/**
 * The findings in a log that match a search.
 *
 * @property findings the matching findings.
 * @property incidents the matching incidents.
 */
class SearchedFindings internal constructor(private val whole: FindingSearch, val findings: List<Finding>, val incidents: List<Incident>) {
    /** The matching [findings] as a list shows them below [incidents]. */
    val beside: BesideIncidents = BesideIncidents(findings, incidents)

    /** A sentence with the numbers of hidden incidents and findings; empty if the search hides nothing. */
    val hidden: String = hiddenBySearch(whole.incidents.size - incidents.size, whole.all.size - findings.size)

    /**
     * The number of [findings] of each severity, the worst first: `1 error, 1 warning`. If the search hides some, their number precedes
     * it: `2 of 14: 1 error, 1 warning`. Empty if nothing was found in the log.
     */
    val counts: String
        get() {
            val ofEach = Severity.entries.reversed()
                .map { severity -> severity to findings.count { it.severity == severity } }
                .filter { (_, count) -> count > 0 }
                .joinToString { (severity, count) -> countText(count, severity.word) }
            if (findings.size == whole.all.size) return ofEach
            val part = "${countText(findings.size)} of ${countText(whole.all.size)}"
            return if (ofEach.isEmpty()) part else "$part: $ofEach"
        }

    companion object {
        /** The text of a list of findings, in place of [counts], if the rules found nothing. */
        const val NOTHING: String = "Nothing was found."
    }
}
