package badlog.viewer.shown.folder

import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.comparison.compared
import badlog.rules.number.LogNumbers
import badlog.viewer.catalog.ListedLog

/**
 * The differences between a log and the matches before it in its folder.
 *
 * @property differences the unusual values, as findings of the rules' comparisons, the largest first.
 * @property previous for each of [differences], the last earlier match that has the compared number.
 */
data class Changes<out E : ListedLog>(val differences: List<Finding> = emptyList(), val previous: Map<Finding, E> = emptyMap()) {
    companion object {
        /** The heading of [differences]. */
        const val TITLE: String = "Unlike the matches before"

        /** Returns the hint for a click on [difference]: its effect, and the next thing to look at. */
        fun hintOf(difference: Finding): String = "Draw it over the previous match. ${difference.next}".trim()
    }
}

/**
 * Returns the [logs] of matches before the match of [log], in the order of time. It returns only the latest ones, as many as may be needed.
 */
fun <E : ListedLog> earlierThan(log: E, logs: List<E>): List<E> = logs.filter {
    it.summary.date.second < log.summary.date.second && !isOfSameRun(it, log)
}.sortedBy { it.summary.date.second }.takeLast(MAX_READ)

/**
 * Returns the differences between [log] and the [earlier] logs of the same kind, by [rules]. [numbersOf] returns the numbers for the
 * rules.
 */
fun <E : ListedLog> changesOf(log: E, earlier: List<E>, rules: RuleSet, numbersOf: (E) -> LogNumbers): Changes<E> {
    val own = numbersOf(log)
    val keys = own.keys.toSet()
    // The Driver Station logs the same matches, but nothing about the robot's actions.
    val alike = earlier.map { it to numbersOf(it) }
        .filter { (_, numbers) -> numbers.kind == own.kind && numbers.keys.any(keys::contains) }
        .takeLast(MAX_COMPARED)
    if (alike.isEmpty()) return Changes()
    val compared = rules.compared(alike.map { it.second } + own).last()
    val previous = compared.findings.zip(compared.numbers) { difference, key -> difference to alike.last { key in it.second.keys }.first }
    return Changes(compared.findings, previous.toMap())
}

/** The maximum number of compared logs: a robot changes over a season. */
private const val MAX_COMPARED = 20

/** The maximum number of logs to read. Between the matches of an event there is practice, and the Driver Station has logs of its own. */
private const val MAX_READ = 100
