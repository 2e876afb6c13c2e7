package badlog.rules.comparison

import badlog.rules.ComparisonRule
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.number.Baseline
import badlog.rules.number.ComparedSignal
import badlog.rules.number.LogNumbers
import badlog.rules.number.Measure
import badlog.rules.number.NumberKey
import badlog.rules.timeText
import badlog.signals.match.MatchKind
import kotlin.math.abs
import kotlin.math.round

/**
 * The differences of a log from the team's others.
 *
 * @property findings the differences that are large enough to be findings, the largest first.
 * @property numbers the key of the number behind each of [findings].
 * @property differences the differences that are large enough to be mentioned in a related incident; [findings] first.
 */
class LogDifferences internal constructor(val findings: List<Finding>, val numbers: List<NumberKey>, val differences: List<Finding>) {
    companion object {
        val NONE: LogDifferences = LogDifferences(emptyList(), emptyList(), emptyList())
    }
}

/**
 * Compares each of [logs] with its neighbors of the same kind, by the comparisons of these rules. [logs] are in the order of the team's
 * matches.
 *
 * @return a result for each log.
 */
fun RuleSet.compared(logs: List<LogNumbers>): List<LogDifferences> {
    val found = arrayOfNulls<LogDifferences>(logs.size)
    if (comparisons.isNotEmpty()) {
        for (kind in MatchKind.entries) {
            val alike = logs.indices.filter { logs[it].kind == kind && logs[it].keys.isNotEmpty() }
            if (alike.size <= comparisons.minOf { it.others }) continue
            val comparison = LogComparison(comparisons, alike.map { logs[it] })
            for ((place, log) in alike.withIndex()) found[log] = comparison.differencesOf(place)
        }
    }
    return found.map { it ?: LogDifferences.NONE }
}

/** Compares [logs] of the same kind by [rules]. */
private class LogComparison(private val rules: List<ComparisonRule>, private val logs: List<LogNumbers>) {
    /** The indices of the logs that have a number, in order, and their values. */
    private class Column {
        val logs = ArrayList<Int>()
        val values = ArrayList<Double>()
    }

    private val columns = HashMap<NumberKey, Column>()

    // Logs with the same topics have the same list of keys.
    private val columnsOf = HashMap<List<NumberKey>, List<Column>>()

    init {
        for ((place, log) in logs.withIndex()) {
            val own = columnsOf(log)
            for (i in log.keys.indices) {
                own[i].logs += place
                own[i].values += log.values[i]
            }
        }
    }

    private class Difference(val rule: ComparisonRule, val key: NumberKey, val value: Double, val usual: Baseline, val strength: Double) {
        val isAbove get() = value > usual.median
    }

    fun differencesOf(place: Int): LogDifferences {
        val log = logs[place]
        val columns = columnsOf(log)
        val found = ArrayList<Difference>()
        for (i in log.keys.indices) {
            val key = log.keys[i]
            val rule = rules.find { key.signal in it.signals } ?: continue
            val others = othersOf(columns[i], place)
            if (others.size >= rule.others) found += differenceOf(log, i, others, rule) ?: continue
        }
        if (found.isEmpty()) return LogDifferences.NONE
        // For each topic, only the largest difference is kept.
        val ofRobot = found.filterNot { isOfDriving(it, found) }
        val differences = ofRobot.sortedByDescending { it.strength }.distinctBy { it.key.topic to it.rule }
        val strong = rules.flatMap { rule -> differences.filter { it.rule === rule && it.strength >= 1 }.take(rule.findings) }
        val findings = strong.sortedByDescending { it.strength }.associateWith { findingOf(it, log) }
        val all = differences.map { findings[it] ?: findingOf(it, log) }
        return LogDifferences(findings.values.toList(), findings.keys.map { it.key }, all)
    }

    /** Returns whether as many motors as no gearbox has differ like [one]: the robot was driven harder, or its pauses were shorter. */
    private fun isOfDriving(one: Difference, all: List<Difference>): Boolean {
        val alike = all.count { other ->
            other.key.signal == one.key.signal && other.key.measure == one.key.measure && other.isAbove == one.isAbove
        }
        return alike >= MANY_MOTORS
    }

    private fun columnsOf(log: LogNumbers) = columnsOf.getOrPut(log.keys) { log.keys.map { columns.getOrPut(it) { Column() } } }

    /** Returns the numbers of the logs nearest to that at [place], because a robot changes over a season. */
    private fun othersOf(column: Column, place: Int): DoubleArray {
        val at = column.logs.binarySearch(place)
        val from = (at - MAX_OTHERS / 2).coerceAtMost(column.logs.size - MAX_OTHERS - 1).coerceAtLeast(0)
        val until = minOf(column.logs.size, from + MAX_OTHERS + 1)
        val others = DoubleArray(until - from - 1)
        var size = 0
        for (i in from until until) if (i != at) others[size++] = column.values[i]
        return others
    }

    private fun differenceOf(log: LogNumbers, number: Int, others: DoubleArray, rule: ComparisonRule): Difference? {
        val key = log.keys[number]
        val value = log.values[number]
        val signal = ComparedSignal.of(key.signal) ?: return null
        val isBothWays = signal.isOfMotor && key.measure == Measure.DRIVING
        val isBelow = others.count { value < it } > others.size / 2
        if (!isBothWays && isBelow != signal.isWorseBelow) return null
        // Most numbers lie within the others, which is seen without sorting.
        if (others.count { if (isBelow) it <= value else it >= value } > MAX_BEYOND) return null
        val usual = Baseline(others)
        // A motor that is usually off, such as a compressor's or a climber's, is on when needed.
        if (signal.isOfMotor && abs(usual.median) < MIN_AMPS) return null
        var away = abs(value - usual.median)
        if (key.measure == Measure.RESISTANCE) away -= log.uncertainty
        val least = if (signal.isRatio) maxOf(signal.least, rule.percent / PERCENT * abs(usual.median)) else signal.least
        // With a few logs, their usual distance from each other is not well known.
        val few = 1 + SMALL_SAMPLE_ALLOWANCE / usual.count
        val scale = maxOf(usual.distance, if (signal.isRatio) MIN_SHARE * abs(usual.median) else MIN_PART * signal.least)
        val strength = minOf(away / (rule.deviations * few * scale), away / (BEYOND_SECOND * usual.second))
        return if (strength >= MIN_STRENGTH && away >= least) Difference(rule, key, value, usual, strength) else null
    }

    private fun findingOf(difference: Difference, log: LogNumbers): Finding {
        val (key, usual) = difference.key to difference.usual
        val text = difference.rule.text.filled(
            mapOf(
                "topic" to key.topic,
                "when" to key.measure.words,
                "value" to if (key.measure == Measure.RESISTANCE) resistanceText(log) else threeDigitText(difference.value, key.unit),
                "difference" to differenceText(difference),
                "usual" to threeDigitText(usual.median, key.unit),
                "others" to "${usual.count} other ${log.kind.words}",
            ),
        )
        val evidence = log.evidenceOf(key)
        val rule = difference.rule
        return Finding(
            rule.name,
            rule.severity,
            evidence.firstOrNull(),
            text,
            Double.NaN,
            emptyList(),
            1,
            "",
            evidence = evidence,
            next = rule.next,
            isForEach = true,
            trust = rule.trust,
        )
    }

    private val MatchKind.words: String
        get() = when (this) {
            MatchKind.MATCH -> "matches"
            MatchKind.PRACTICE -> "practice runs"
            MatchKind.UNKNOWN -> "logs"
        }

    private fun differenceText(difference: Difference): String {
        val away = difference.value - difference.usual.median
        val word = if (away > 0) "above" else "below"
        val median = difference.usual.median
        val isRatio = ComparedSignal.of(difference.key.signal)?.isRatio == true
        if (!isRatio || median <= 0) return "${threeDigitText(abs(away), difference.key.unit)} $word"
        val ratio = difference.value / median
        return if (ratio >= MIN_RATIO) "${threeDigitText(ratio, "")} times" else "${round(abs(away) / median * PERCENT).toInt()} % $word"
    }
}

/** Returns the resistance of a log's battery with its uncertainty: `24.8 ± 0.9 mΩ`. Empty if the log does not show it. */
fun resistanceText(log: LogNumbers): String =
    if (log.resistance.isNaN()) "" else "${tenths(log.resistance)} ± ${tenths(maxOf(log.uncertainty, MIN_SHOWN))} mΩ"

private fun tenths(value: Double) = timeText(round(value * 10) / 10, "")

private const val MIN_SHOWN = 0.1

/** Returns the topics that show [key]: its own, and for the resistance also the topic of the current. */
private fun LogNumbers.evidenceOf(key: NumberKey): List<String> {
    val current = if (key.measure == Measure.RESISTANCE) keys.find { it.signal == "total current" }?.topic else null
    return listOfNotNull(key.topic, current).filter { it != SUM_OF_CHANNELS }
}

/** Returns [value] with its unit, rounded to three digits: `23.1 A`. */
fun threeDigitText(value: Double, unit: String): String = timeText(threeDigits(value), unit)

private fun threeDigits(value: Double): Double {
    var scale = 1.0
    while (abs(value) * scale < 100 && scale < 1e6) scale *= 10
    return round(value * scale) / scale
}

/** The maximum number of other logs that a log is compared with. */
private const val MAX_OTHERS = 20
private const val MAX_BEYOND = 1
private const val SMALL_SAMPLE_ALLOWANCE = 8.0
private const val PERCENT = 100.0
private const val MIN_SHARE = 0.03
private const val MIN_PART = 0.25
private const val BEYOND_SECOND = 1.5
private const val MIN_RATIO = 3.0
private const val MIN_AMPS = 0.5
private const val MANY_MOTORS = 3

/** Only a few numbers are related to an incident, so a smaller difference is enough. */
private const val MIN_STRENGTH = 0.5
