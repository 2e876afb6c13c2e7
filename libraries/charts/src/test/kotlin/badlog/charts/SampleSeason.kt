package badlog.charts

import badlog.charts.match.ChartedLog
import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.comparison.numbersOf
import badlog.samples.fault.Fault
import badlog.samples.fault.FaultyMatch
import badlog.signals.match.MatchOfLog

/** Returns the logs of [count] simulated matches of one event, a few of them with faults. */
internal fun sampleSeason(count: Int): List<ChartedLog> = (1..count).toList().parallelStream().map { number ->
    val fault = when (number % 12) {
        5 -> Fault.TIRED_BATTERY
        9 -> Fault.entries.firstOrNull { "loop" in it.title }
        else -> null
    }
    val bag = FaultyMatch(400 + number, fault, isFaint = false).bag()
    val view = LogView.of(BagParser().apply { accept(bag) }.finish())
    val match = MatchOfLog("Mill Creek Regional", "Qualification", "${3 * number - 1}")
    ChartedLog(match, "q$number.bag", began = 600L * number, numbersOf(view, RuleSet.BUILT_IN.signals, "q$number.bag"))
}.toList()
