package badlog.rules.incident

import badlog.analysis.Span
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.cause.Cause

/**
 * The incidents in a log in which these rules have found [findings]: those causes of the rules that findings show, the worst first.
 * A finding that shows a cause but follows from another one begins no incident of its own.
 *
 * @param differences what was different from the team's other matches, the most different first; an incident says the first that is
 *   of a topic that shows it.
 */
public fun RuleSet.incidentsIn(findings: List<Finding>, differences: List<Finding> = emptyList()): List<Incident> {
    val ofRules = findings.filter { !it.isOfHook }
    val explained = HashSet<Finding>()
    val found = ArrayList<Incident>()
    for (cause in causes.causes) {
        val shown = ofRules.filter { it !in explained && cause.isShownBy(it.rule, it.topic) }
        val showing = togetherIn(shown, cause)
        if (showing.isEmpty()) continue
        val reached = causes.reachedFrom(showing.map { it.rule })
        val effects = ofRules.filter { it.rule in reached && it !in showing && it !in explained && follows(it, showing) }
        if (cause.onlyWith.isNotEmpty() && effects.none { it.rule in cause.onlyWith }) continue
        explained += showing
        explained += effects
        val evidence = showing.flatMapTo(HashSet()) { it.evidence } + effects.mapNotNull { it.topic }
        val difference = differences.find { difference -> difference.evidence.any { it in evidence } }
        found += Incident(cause.name, showing.sortedBy { it.time }, effects.sortedBy { it.time }, cause.next, difference)
    }
    return found.sortedWith(compareBy({ -it.severity.ordinal }, { -it.effects.size }, { it.time }))
}

/** Those of [findings] that show [cause], with as many topics at once as it needs. */
private fun togetherIn(findings: List<Finding>, cause: Cause): List<Finding> {
    if (cause.together == 1) return findings
    return findings.filter { one -> findings.count { other -> other === one || overlap(one, other) } >= cause.together }
}

private fun overlap(one: Finding, other: Finding) = one.first.any { span -> other.first.any { it.from <= span.to && it.to >= span.from } }

// However many spans were kept, the same log has the same incidents.
private val Finding.first get() = spans.take(Finding.MAX_SPANS)

/** Whether [effect] began while one of [causes] was there, or soon after. What is of the whole log is there at all times. */
private fun follows(effect: Finding, causes: List<Finding>): Boolean = effect.spans.isEmpty() || causes.any { cause ->
    cause.spans.isEmpty() || cause.first.any { span -> effect.first.any { begins(it, span) } }
}

private fun begins(effect: Span, cause: Span) = effect.from >= cause.from - EARLIEST && effect.from <= cause.to + LATEST

// Some rules need half a second to be sure, so that an effect may be found before its cause. In seconds, as nearly all logs count.
private const val EARLIEST = 1.0
private const val LATEST = 3.0
