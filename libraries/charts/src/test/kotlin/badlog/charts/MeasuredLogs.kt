package badlog.charts

import badlog.charts.match.ChartedLog
import badlog.rules.number.LogNumbersReader
import badlog.rules.number.LogNumbersText
import badlog.rules.number.Measure
import badlog.signals.match.MatchKind
import badlog.signals.match.MatchOfLog

/** Invented numbers, each with a signal, a topic, a measure, a unit and a value. */
internal class InventedNumbers(private val kind: MatchKind = MatchKind.MATCH) {
    private val names = ArrayList<String>()
    private val values = ArrayList<Double>()
    private val distributions = ArrayList<String>()

    fun number(signal: String, measure: Measure, value: Double, topic: String = signal, unit: String = ""): InventedNumbers = apply {
        names += listOf(signal, topic, measure.ordinal, unit).joinToString("\t")
        values += value
    }

    /** Adds a distribution; [seconds] is the time in each bin of 1 ms. */
    fun distribution(signal: String, quantiles: List<Double>, seconds: List<Double> = emptyList()): InventedNumbers = apply {
        distributions += listOf(signal, "", quantiles.joinToString(";"), if (seconds.isEmpty()) 0.0 else 1.0, seconds.joinToString(";")).joinToString("\t")
    }

    fun numbers() = LogNumbersReader().read(
        LogNumbersText(names.joinToString("\n"), "${kind.ordinal};1.5;false;false;" + values.joinToString(";"), distributions.joinToString("\n")),
    )
}

/** Returns a log of match [number] with data for all charts; the lowest voltage of the battery is [volts]. */
internal fun measuredLog(
    number: Int,
    volts: Double = 9.0 + 0.1 * (number % 7),
    match: MatchOfLog = MatchOfLog("Mill Creek", "Qualification", "$number"),
    kind: MatchKind = MatchKind.MATCH,
    began: Long? = 600L * number,
    change: InventedNumbers.() -> Unit = {},
): ChartedLog {
    val made = InventedNumbers(kind)
        .number("battery", Measure.LOWEST, volts)
        .number("battery resistance", Measure.RESISTANCE, 14.0 + number % 5)
        .number("packet loss", Measure.ENABLED, 0.5 + 0.1 * (number % 3))
        .number("motor temperature", Measure.HIGHEST, 50.0 + number, "Drive/Left/Temperature")
        .number("motor temperature", Measure.HIGHEST, 40.0 + number, "Drive/Right/Temperature")
        .distribution(
            "loop time",
            listOf(5.0, 6.0, 7.0, 8.0, 9.0, 12.0, 20.0 + number),
            List(61) {
                if (it == 8) {
                    140.0
                } else if (it == 30) {
                    0.5
                } else {
                    0.0
                }
            },
        )
        .distribution("total current", listOf(0.0, 5.0, 20.0, 40.0, 60.0, 100.0 + number, 220.0))
    return ChartedLog(match, "q$number.bag", began, made.apply(change).numbers())
}
