package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.look.ChartTexts
import badlog.charts.match.ChartedMatches
import badlog.charts.match.LEAST_MATCHES

/** A kind of chart: makes it of matches. */
internal fun interface ChartKind {
    fun of(matches: ChartedMatches): MadeChart
}

/** The [chart] called [name], or, if it is null, what is [lacking] for it, as a sentence. */
internal class MadeChart private constructor(val name: String, val chart: Chart?, val lacking: String) {
    constructor(chart: Chart) : this(chart.name, chart, "")

    constructor(name: String, lacking: String) : this(name, null, lacking)
}

/** Returns a sentence that the chart of [texts] lacks logs that show [what], which only [known] of them do. */
internal fun lacking(texts: ChartTexts, what: String, known: Int): MadeChart {
    val found = when (known) {
        0 -> "no log shows it"
        1 -> "only 1 log shows it"
        else -> "only $known logs show it"
    }
    return MadeChart(texts.name, "“${texts.title}” needs $what in at least $LEAST_MATCHES logs; $found.")
}
