package badlog.report

import badlog.files.terminal.TextTable
import badlog.viewer.shown.battery.AdvisedBattery
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatteryColumn
import badlog.viewer.shown.battery.BatterySeason
import kotlinx.serialization.Serializable

/** Returns [seasons] as a table for a terminal of [width] columns, and below it the advice for the batteries. */
fun batteryText(seasons: List<BatterySeason>, width: Int = Int.MAX_VALUE): String {
    val columns = BatteryColumn.of(seasons)
    val table = TextTable(columns.map { TextTable.Column(it.title, isNumber = it.isNumber) }, width, repeated = 1)
    val advised = BatteryAdvice.of(seasons).all.map { it.text }
    return (
        table.text(
            seasons.map { season ->
                columns.map { it.text(season) ?: "–" }
            },
        ) + listOfNotNull("".takeIf { advised.isNotEmpty() }) +
            advised
        )
        .joinToString("\n")
}

/** Returns [seasons] as CSV (RFC 4180): exact numbers, and an empty cell for none. */
fun batteryCsv(seasons: List<BatterySeason>): String {
    val head = CSV_COLUMNS.joinToString(",")
    val lines = seasons.map { season ->
        with(season) {
            listOf(
                title,
                matches.size,
                lowest,
                resistance?.milliohms,
                resistance?.uncertainty,
                growth?.milliohms,
                restBefore,
                restAfter,
                energy,
                age,
            ).joinToString(",") { cell(it?.toString().orEmpty()) }
        }
    }
    return (listOf(head) + lines).joinToString("") { "$it\r\n" }
}

private val CSV_COLUMNS = listOf(
    "Battery",
    "Matches",
    "Lowest (V)",
    "Resistance (mOhm)",
    "Uncertainty (mOhm)",
    "Growth (mOhm)",
    "Rest before (V)",
    "Rest after (V)",
    "Energy (Wh)",
    "Age (months)",
)

/** A battery in the form for other programs, in volts, milliohms, watt-hours and months. The name of an unknown battery is null. */
@Serializable
class BatteryJson private constructor(
    private val battery: String?,
    private val matches: List<String>,
    private val lowest: Double?,
    private val resistance: ResistanceJson?,
    private val growth: ResistanceJson?,
    private val restBefore: Double?,
    private val restAfter: Double?,
    private val energy: Double?,
    private val age: Int?,
    private val isRetired: Boolean,
    private val advice: String?,
    private val reason: String?,
) {
    constructor(season: BatterySeason, advice: AdvisedBattery?) : this(
        season.battery?.name,
        season.matches.map { it.title },
        finite(season.lowest),
        season.resistance?.let { ResistanceJson(it.milliohms, it.uncertainty) },
        season.growth?.let { ResistanceJson(it.milliohms, it.uncertainty) },
        finite(season.restBefore),
        finite(season.restAfter),
        finite(season.energy),
        season.age,
        season.battery?.isRetired ?: false,
        advice?.step?.label,
        advice?.reason,
    )
}
