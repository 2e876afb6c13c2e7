package badlog.plot.search

import badlog.plot.text.countText
import badlog.rules.Finding
import badlog.rules.incident.Incident

/** What a [Query] is asked of, in lower case: the rule, how bad it is, and what it says. */
public val Finding.searchedText: String get() = "$rule ${severity.name} $text".lowercase()

/** What a [Query] is asked of, in lower case: all that is said of the incident. */
public val Incident.searchedText: String get() = "$name ${sentences.joinToString(" ") { it.text }} $next".lowercase()

/** Whether this finds a finding or an incident with [searchedText]. */
public fun Query.findsFound(searchedText: String): Boolean = matchesLowercase(searchedText, FINDING)

/** Says that a search hides so many [incidents] and [findings], as a sentence; empty where it hides none. */
public fun hiddenBySearch(incidents: Int, findings: Int): String =
    listOf("incident" to incidents, "finding" to findings).filter { it.second > 0 }
        .joinToString(" and ") { (name, number) -> countText(number, name) }
        .let { if (it.isEmpty()) "" else "$it hidden by the search." }

private val FINDING = setOf(Trait.FINDING)
