package badlog.viewer.shown.folder

import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.comparison.compared
import badlog.rules.number.LogFigures
import badlog.viewer.catalog.ListedLog

/**
 * How a log differs from the matches before it in its folder.
 *
 * @property differences what is unusual, as the comparisons of the rules say it, the largest first.
 * @property previous the log of the match before it; null if there is none.
 */
data class Changes<out E : ListedLog>(val differences: List<Finding> = emptyList(), val previous: E? = null)

/** Returns those of [logs] that are of matches before that of [log], in the order of time; only as many of the last as may be needed. */
fun <E : ListedLog> earlierThan(log: E, logs: List<E>): List<E> = logs.filter {
    it.summary.date.second < log.summary.date.second && !isOfSameRun(it, log)
}.sortedBy { it.summary.date.second }.takeLast(MOST_READ)

/** Returns how [log] differs from those of the [earlier] ones that are of the same kind, by [rules], for which [figuresOf] returns figures. */
fun <E : ListedLog> changesOf(log: E, earlier: List<E>, rules: RuleSet, figuresOf: (E) -> LogFigures): Changes<E> {
    val own = figuresOf(log)
    if (own.keys.isEmpty()) return Changes()
    val alike = earlier.map {
        it to figuresOf(it)
    }.filter { (_, figures) -> figures.kind == own.kind && figures.keys.isNotEmpty() }.takeLast(MOST)
    return Changes(rules.compared(alike.map { it.second } + own).last().findings, alike.lastOrNull()?.first)
}

/** A robot changes over a season. */
private const val MOST = 20

/** Between the matches of an event there is practice, and the Driver Station has logs of its own. */
private const val MOST_READ = 100
