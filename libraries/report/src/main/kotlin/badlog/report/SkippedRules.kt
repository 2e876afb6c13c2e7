package badlog.report

import badlog.catalog.examine.RuleOutcome
import badlog.rules.Rule
import badlog.rules.RuleSet
import badlog.rules.SkippedRule
import java.util.IdentityHashMap

/** Determines which of [rules] were skipped. A list shared by many logs is examined once. Not thread-safe. */
internal class SkippedRules(private val rules: RuleSet) {
    private val ruleOf = rules.rules.associateBy { it.name }
    private val known = IdentityHashMap<List<RuleOutcome>, List<SkippedRule>>()

    /** Returns the rules skipped for a log. */
    fun of(asked: List<RuleOutcome>): List<SkippedRule> = known.getOrPut(asked) {
        asked.mapNotNull { skipped(ruleOf.getValue(it.rule), listOf(it to 1)) }
    }

    /** Returns the rules skipped for some of [logs], in the order of the rules; [readable] is the number of logs that could be read. */
    fun ofAll(logs: List<List<RuleOutcome>>, readable: Int): List<SkippedRule> {
        val times = IdentityHashMap<List<RuleOutcome>, Int>()
        for (asked in logs) times.merge(asked, 1, Int::plus)
        val first = IdentityHashMap<List<RuleOutcome>, Unit>()
        val ofRule = HashMap<String, ArrayList<Pair<RuleOutcome, Int>>>()
        for (asked in logs) {
            if (first.put(asked, Unit) == null) asked.forEach { ofRule.getOrPut(it.rule) { ArrayList() } += it to times.getValue(asked) }
        }
        return rules.rules.mapNotNull { rule -> ofRule[rule.name].let { if (it == null) notRun(rule, readable) else skipped(rule, it) } }
    }

    private fun notRun(rule: Rule, logs: Int): SkippedRule? {
        val types = rule.only.joinToString(" or ") { "“$it”" }
        return if (logs == 0) null else SkippedRule(rule.name, logs, "it is only for matches of the type $types", isMistake = false)
    }

    /** Combines the outcomes of [rule], each with its number of logs. */
    private fun skipped(rule: Rule, asked: List<Pair<RuleOutcome, Int>>): SkippedRule? {
        val refused = asked.filter { (outcome, _) -> outcome.refusal != null }
        val mistaken = refused.find { (outcome, _) -> outcome.mistake != null }
        if (refused.isEmpty()) return null
        val first = (mistaken ?: mostHelpful(refused, { (_, logs) -> logs }) { (outcome, _) -> outcome.refusal.orEmpty() }).first
        // A rule that runs for one log is valid; other logs only lack its topics.
        val isMistake = mistaken != null && refused.size == asked.size
        val logs = refused.sumOf { (_, logs) -> logs }
        val why = (if (isMistake) first.mistake else first.refusal).orEmpty()
        return SkippedRule(rule.name, logs, why, isMistake, rule.isBuiltIn, first.lacking, first.simulated)
    }
}
