package badlog.viewer.shown.battery

import badlog.viewer.text.countText
import badlog.viewer.text.fixedText
import kotlin.math.floor

/** Returns `14 months`, or `3 years` from two years on. */
private fun ageText(months: Int) = if (months < MONTHS_TOLD) countText(months, "month") else countText(months / MONTHS_OF_YEAR, "year")

private const val MONTHS_OF_YEAR = 12
private const val MONTHS_TOLD = 24

/**
 * The columns of the table of batteries.
 *
 * @property title the heading.
 * @property meaning the content, as a sentence.
 * @property isNumber whether the column is aligned to the right.
 * @property text returns the displayed text; null if unknown.
 */
enum class BatteryColumn(val title: String, val meaning: String, val isNumber: Boolean = true, val text: (BatterySeason) -> String?) {
    BATTERY("Battery", "The team's name for it.", isNumber = false, text = { it.title }),
    MATCHES("Matches", "The number of matches and other runs with this battery.", text = { "${it.matches.size}" }),

    // Rounded down, so that the battery does not look better than it was.
    LOWEST("Lowest", "The lowest voltage in all matches.", text = { season ->
        season.lowest?.let { voltsText(floor(it * 100 + 1e-6) / 100) }
    }),
    RESISTANCE(
        "Resistance",
        "The resistance of battery and wiring over all matches, and its uncertainty (95 %).",
        text = { season -> season.resistance?.let(::resistanceText) },
    ),
    GROWTH(
        "Growth",
        "How much the resistance grew from the earlier half of its matches to the later half, if that is beyond the uncertainty.",
        text = { season -> season.growth?.let { "+${resistanceText(it)}" } },
    ),
    REST_BEFORE(
        "Rest before",
        "The median voltage in the 10 s before the robot was enabled.",
        text = { season -> season.restBefore?.let(::voltsText) },
    ),
    REST_AFTER(
        "Rest after",
        "The median voltage at the end of the logs, at least 5 s after the robot was disabled.",
        text = { season -> season.restAfter?.let(::voltsText) },
    ),
    ENERGY(
        "Energy",
        "The energy that a match uses, on average; without matches, the energy of other runs.",
        text = { season -> season.energy?.let { "${fixedText(it, 1)} Wh" } },
    ),
    AGE("Age", "Its age at the last match.", text = { season -> season.age?.let(::ageText) }),
    ;

    companion object {
        /** Returns the columns that have a text for any of [seasons]. */
        fun of(seasons: List<BatterySeason>): List<BatteryColumn> = entries.filter { column -> seasons.any { column.text(it) != null } }
    }
}
