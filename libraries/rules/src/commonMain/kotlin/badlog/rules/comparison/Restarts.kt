package badlog.rules.comparison

import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.number.LogNumbers

/**
 * A log in a folder of logs.
 *
 * @property match its match; null if it does not show one.
 * @property found the rules' findings in it alone.
 */
class LogOfFolder(val file: String, val match: String?, val numbers: LogNumbers, val found: List<Finding>)

/**
 * Returns, for each of [logs], the finding that the robot code restarted before it; otherwise null. [logs] are in the order of time. After
 * a restart, a log begins with an enabled robot, and the log before it, of the same match, ended with one. A restart that the log alone
 * already shows is not reported again.
 */
fun RuleSet.restartsIn(logs: List<LogOfFolder>): List<Finding?> {
    val rule = rules.find { it.name == RESTARTED }
    return logs.mapIndexed { at, log ->
        val before = logs.getOrNull(at - 1)?.takeIf { log.match != null && it.match == log.match && it.numbers.endsEnabled }
        if (rule == null || before == null || !log.numbers.beginsEnabled || log.found.any { it.rule == RESTARTED }) return@mapIndexed null
        val text = "The log begins while the robot was enabled, and “${before.file}”, of the same match, ended so: " +
            "the robot code had restarted."
        Finding(rule.name, rule.severity, null, text, Double.NaN, emptyList(), 1, "", next = rule.next, trust = rule.trust)
    }
}

private const val RESTARTED = "Restarted in the match"
