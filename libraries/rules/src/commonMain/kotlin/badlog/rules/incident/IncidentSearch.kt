package badlog.rules.incident

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.cause.Cause
import badlog.rules.standing.Standing

/**
 * Returns the incidents among [findings], which these rules found in a log; the worst first. Each cause that findings show has one.
 * Only findings of proven rules show a cause. A finding that shows a cause but follows from another one does not begin a separate incident.
 *
 * @param differences the log's differences from the team's other matches, the greatest first; an incident mentions the first one about its
 *   own topics.
 */
fun RuleSet.incidentsIn(findings: List<Finding>, differences: List<Finding> = emptyList()): List<Incident> {
    val ofRules = findings.filter { !it.isOfHook }
    val unproven = rules.filter { it.standing != Standing.PROVEN }.mapTo(HashSet()) { it.name }
    val explained = HashSet<Finding>()
    val found = ArrayList<Incident>()
    for (cause in causes.causes) {
        val shown = ofRules.filter { it !in explained && it.rule !in unproven && cause.isShownBy(it.rule, it.topic) }
        val showing = togetherIn(shown, cause)
        if (showing.isEmpty()) continue
        val reached = causes.reachedFrom(showing.map { it.rule })
        val effects = ofRules.filter { it.rule in reached && it !in showing && it !in explained && follows(it, showing) }
        if (cause.onlyWith.isNotEmpty() && effects.none { it.rule in cause.onlyWith && it.rule !in unproven }) continue
        explained += showing
        explained += effects
        val evidence = showing.flatMapTo(HashSet()) { it.evidence } + effects.mapNotNull { it.topic }
        val difference = differences.find { difference -> difference.evidence.any { it in evidence } }
        found += Incident(nameOf(cause, showing), showing.sortedBy { it.time }, effects.sortedBy { it.time }, cause.next, difference)
    }
    return found.sortedWith(compareBy({ -it.severity.ordinal }, { -it.effects.size }, { it.time }))
}

/** Returns the name of [cause], with the signals that were unusual each time. It does not say which led to which. */
private fun nameOf(cause: Cause, showing: List<Finding>): String {
    val signals = showing.flatMap { it.meanwhile }.distinct()
    return if (signals.isEmpty()) cause.name else "${cause.name} while ${signals.joinToString(" and ")} rose"
}

/** Returns the [findings] that show [cause], with as many simultaneous topics as it requires. */
private fun togetherIn(findings: List<Finding>, cause: Cause): List<Finding> {
    if (cause.together == 1) return findings
    return findings.filter { one -> findings.count { other -> other === one || overlap(one, other) } >= cause.together }
}

private fun overlap(one: Finding, other: Finding) = one.first.any { span -> other.first.any { it.from <= span.to && it.to >= span.from } }

// Limited, so that the same log has the same incidents however many spans were kept.
private val Finding.first get() = spans.take(Finding.MAX_SPANS)

/** Returns whether [effect] began during one of [causes], or soon after. A finding about the whole log lasts all the time. */
private fun follows(effect: Finding, causes: List<Finding>): Boolean = effect.spans.isEmpty() || causes.any { cause ->
    cause.spans.isEmpty() || cause.first.any { span -> effect.first.any { begins(it, span) } }
}

private fun begins(effect: Span, cause: Span) = effect.from >= cause.from - EARLIEST && effect.from <= cause.to + LATEST

// Some rules need half a second to be sure, so an effect may be found before its cause. In seconds, the unit of nearly all logs.
private const val EARLIEST = 1.0
private const val LATEST = 3.0
