package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.match.ChartedMatches

/** A kind of chart: makes it of matches. */
internal fun interface ChartKind {
    fun of(matches: ChartedMatches): MadeChart
}

/** A [chart], or, if it is null, what is [lacking] for it, as a sentence. */
internal class MadeChart(val chart: Chart?, val lacking: String = "")

/** The smallest number of matches of which a chart says more than their numbers do. */
internal const val LEAST_MATCHES = 3

/** Returns a sentence that [title] lacks logs that show [what], which only [known] of them do. */
internal fun lacking(title: String, what: String, known: Int): MadeChart {
    val found = when (known) {
        0 -> "no log shows it"
        1 -> "only 1 log shows it"
        else -> "only $known logs show it"
    }
    return MadeChart(null, "“$title” needs $what in at least $LEAST_MATCHES logs; $found.")
}
