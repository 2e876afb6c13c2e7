package badlog.viewer.shown.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
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

/** The text that a [Query] searches, in lower case: the rule, the severity and the message. */
internal val Finding.searchedText: String get() = "$rule ${severity.name} $text".lowercase()

/** The text that a [Query] searches, in lower case: all texts of the incident, and all its findings. */
internal val Incident.searchedText: String
    get() = "$name ${sentences.joinToString(" ") { it.text }} $next ${(causes + effects).joinToString(" ") { it.searchedText }}".lowercase()

/** Returns whether this query matches a finding or an incident with [searchedText]. */
internal fun Query.findsFound(searchedText: String): Boolean = matchesLowercase(searchedText, FINDING)

/** Returns a sentence with the number of [incidents] and [findings] that a search hides; empty if it hides none. */
internal fun hiddenBySearch(incidents: Int, findings: Int): String = listOf("incident" to incidents, "finding" to findings)
    .filter { it.second > 0 }
    .joinToString(" and ") { (name, number) -> countText(number, name) }
    .let { if (it.isEmpty()) "" else "$it hidden by the search." }

private val FINDING = setOf(Trait.FINDING)

/**
 * The findings that a list shows below the incidents, without those that the incidents mention.
 *
 * @property outside the findings outside of all incidents, in their order.
 * @property within the findings of an incident that does not mention them; lists fold them.
 */
class BesideIncidents(found: List<Finding>, incidents: List<Incident>) {
    val outside: List<Finding>
    val within: List<Finding>

    init {
        val mentioned = incidents.flatMapTo(HashSet()) { incident -> incident.sentences.map { it.finding } }
        val (within, outside) = found.filter { it !in mentioned }.partition { finding -> incidents.any { finding in it } }
        this.within = within
        this.outside = outside
    }
}
