package badlog.viewer.shown.finding

import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import badlog.viewer.text.countText

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
