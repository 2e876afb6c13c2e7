package badlog.viewer.shown.folder

import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.comparison.compared
import badlog.rules.number.LogNumbers
import badlog.viewer.catalog.ListedLog

/**
 * How a log differs from the matches before it in its folder.
 *
 * @property differences what is unusual, as the comparisons of the rules say it, the largest first.
 * @property previous the last match before it that shows the same, for each of [differences].
 */
data class Changes<out E : ListedLog>(val differences: List<Finding> = emptyList(), val previous: Map<Finding, E> = emptyMap()) {
    companion object {
        /** The heading of [differences]. */
        const val TITLE: String = "Unlike the matches before"

        /** Returns what a click on [difference] does, and what to look at next. */
        fun hintOf(difference: Finding): String = "Draw it over the match before. ${difference.next}".trim()
    }
}

/** Returns those of [logs] that are of matches before that of [log], in the order of time; only as many of the last as may be needed. */
fun <E : ListedLog> earlierThan(log: E, logs: List<E>): List<E> = logs.filter {
    it.summary.date.second < log.summary.date.second && !isOfSameRun(it, log)
}.sortedBy { it.summary.date.second }.takeLast(MOST_READ)

/** Returns how [log] differs from those of the [earlier] ones that are of the same kind, by [rules], for which [numbersOf] returns numbers. */
fun <E : ListedLog> changesOf(log: E, earlier: List<E>, rules: RuleSet, numbersOf: (E) -> LogNumbers): Changes<E> {
    val own = numbersOf(log)
    val keys = own.keys.toSet()
    // The Driver Station logs the same matches, but nothing that the robot does.
    val alike = earlier.map { it to numbersOf(it) }
        .filter { (_, numbers) -> numbers.kind == own.kind && numbers.keys.any(keys::contains) }
        .takeLast(MOST)
    if (alike.isEmpty()) return Changes()
    val compared = rules.compared(alike.map { it.second } + own).last()
    val previous = compared.findings.zip(compared.numbers) { difference, key -> difference to alike.last { key in it.second.keys }.first }
    return Changes(compared.findings, previous.toMap())
}

/** A robot changes over a season. */
private const val MOST = 20

/** Between the matches of an event there is practice, and the Driver Station has logs of its own. */
private const val MOST_READ = 100
