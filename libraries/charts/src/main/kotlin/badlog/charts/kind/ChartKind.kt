package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.look.ChartTexts
import badlog.charts.match.ChartedMatches
import badlog.charts.match.MIN_MATCHES

/** A kind of chart; [of] draws one of matches, or says which data is missing. */
internal fun interface ChartKind {
    fun of(matches: ChartedMatches): ChartResult
}

/** The [chart] called [name]; if it is null, [lacking] is a sentence about the missing data. */
internal class ChartResult private constructor(val name: String, val chart: Chart?, val lacking: String) {
    constructor(chart: Chart) : this(chart.name, chart, "")

    constructor(name: String, lacking: String) : this(name, null, lacking)
}

/** Returns a sentence instead of a chart, because too few logs, only [known], show [what]. */
internal fun lacking(texts: ChartTexts, what: String, known: Int): ChartResult {
    val found = when (known) {
        0 -> "no log shows it"
        1 -> "only 1 log shows it"
        else -> "only $known logs show it"
    }
    return ChartResult(texts.name, "“${texts.title}” needs $what in at least $MIN_MATCHES logs; $found.")
}
