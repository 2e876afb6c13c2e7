package badlog.viewer.shown.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countText
import badlog.viewer.text.word

/**
 * What was found in a log, for a person who searches it. The searched texts are made at the first search.
 *
 * @property all the findings, the worst first.
 * @property incidents which of them belong together, the worst first.
 */
class FindingSearch(val all: List<Finding>, val incidents: List<Incident>) {
    private val texts by lazy { all.map { it.searchedText } }
    private val textsOfIncidents by lazy { incidents.map { it.searchedText } }

    /** Returns what [query] finds of it, in the same order; all of it for an empty query. */
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
 * What a search leaves of what was found in a log.
 *
 * @property findings the findings that it leaves.
 * @property incidents the incidents that it leaves.
 */
class SearchedFindings internal constructor(private val whole: FindingSearch, val findings: List<Finding>, val incidents: List<Incident>) {
    /** Those of [findings] that a list shows below [incidents]. */
    val beside: BesideIncidents = BesideIncidents(findings, incidents)

    /** A sentence that says how much the search hides; empty if it hides nothing. */
    val hidden: String = hiddenBySearch(whole.incidents.size - incidents.size, whole.all.size - findings.size)

    /**
     * How many [findings] there are of each severity, the worst first, after the part of all that they are, unless they are all:
     * `2 of 14: 1 error, 1 warning`. Empty if nothing was found in the log.
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
        /** What a list of findings says in place of [counts] after rules that found nothing. */
        const val NOTHING: String = "Nothing was found."
    }
}
