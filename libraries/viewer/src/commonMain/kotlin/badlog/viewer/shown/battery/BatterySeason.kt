package badlog.viewer.shown.battery

import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.battery.TeamBattery
import badlog.signals.battery.meanOf
import badlog.signals.match.MatchKind
import badlog.signals.match.NaturalOrder
import badlog.viewer.catalog.ListedLog
import badlog.viewer.shown.folder.MatchRun
import badlog.viewer.shown.folder.runsOf
import badlog.viewer.text.isoText
import kotlin.math.sqrt

/**
 * A match, or another run of the robot, with the use of its battery.
 *
 * @property title the displayed name.
 * @property paths the logs of the run, the most informative one first.
 * @property second the time when the run began, in s since 1970 on a local wall clock.
 * @property isMatch whether the run is known to be a match that counts, rather than practice.
 */
class BatteryMatch(val title: String, val paths: List<String>, val second: Long, val use: BatteryUse, val isMatch: Boolean)

/**
 * A battery over a season.
 *
 * @property battery the battery; null for the matches with an unknown battery.
 * @property matches the matches with the battery in the robot, the latest first.
 * @property age the age in months at the last match with any battery; null if the date of purchase is unknown.
 */
class BatterySeason(val battery: TeamBattery?, val matches: List<BatteryMatch>, val age: Int? = null) {
    /** The displayed name. */
    val title: String get() = battery?.name ?: "Unknown"

    /** The lowest voltage in all matches, in volts; null if no match shows it. */
    val lowest: Double? = matches.mapNotNull { it.use.lowest }.minOrNull()

    /** The resistance of battery and wiring in all matches together. */
    val resistance: Resistance? = meanOf(resistancesOf(matches))

    /** The growth of the resistance from the earlier half of the matches to the later one. Null if it is within the uncertainty. */
    val growth: Resistance? = if (battery == null) null else growthIn(matches)

    /** The median voltage at rest before a match, in volts. */
    val restBefore: Double? = medianOf(matches.mapNotNull { it.use.restBefore })

    /** The median voltage at rest after a match, in volts. */
    val restAfter: Double? = medianOf(matches.mapNotNull { it.use.restAfter })

    /** The mean energy used in a match, or in another run if there are no matches, in watt-hours; null if unknown. */
    val energy: Double? = matches.filter {
        it.isMatch
    }.ifEmpty { matches }.mapNotNull { it.use.energy }.let { if (it.isEmpty()) null else it.average() }

    /** A key that distinguishes the battery even if its name is the text for unknown batteries. */
    val key: String get() = battery?.let { "battery ${it.name}" } ?: "unknown"

    companion object {
        /**
         * Returns the batteries in [logs] and the ones that the team wrote down, ordered by name. Retired ones are last, followed by the
         * unknown one.
         *
         * @param team the batteries of the team.
         * @param usedFor returns the battery that the team wrote down for one of the logs of a match; null if it did not.
         */
        fun <E : ListedLog> of(
            logs: List<E>,
            team: List<TeamBattery> = emptyList(),
            usedFor: (List<E>) -> String? = { null },
        ): List<BatterySeason> {
            // A copy of a log says the same of the same time.
            val used = logs.filter { it.isReadable && !it.isGray && it.summary.battery != null }.distinctBy(::contentOf)
            val matches = runsOf(used)
                .map { run -> (usedFor(run.logs) ?: run.logs.firstNotNullOfOrNull { it.summary.battery?.name }) to matchOf(run) }
                .groupBy({ it.first?.lowercase() }, { it })
            val last = matches.values.maxOfOrNull { it.first().second.second }
            val named = (team.map { it.name } + matches.values.mapNotNull { it.first().first }).distinctBy { it.lowercase() }
            val known = named.map { name ->
                val battery = team.find { it.name.equals(name, ignoreCase = true) } ?: TeamBattery(name)
                BatterySeason(battery, ofBattery(matches[name.lowercase()]), last?.let { battery.monthsUntil(isoText(it)) })
            }
            val order = compareBy<BatterySeason> { it.battery?.isRetired }.thenBy(NaturalOrder) { it.title }
            return known.sortedWith(order) + listOfNotNull(matches[null]?.let { BatterySeason(null, ofBattery(it)) })
        }

        // Not the whole summary, which may have thousands of topics.
        private fun contentOf(log: ListedLog) = with(log.summary) { listOf(match, date, duration, samples, battery) }

        private fun ofBattery(named: List<Pair<String?, BatteryMatch>>?) = named.orEmpty().map { it.second }
    }
}

/** Returns the match of [run]. The logs of the robot and of the Driver Station have different facts about one battery. */
private fun matchOf(run: MatchRun<out ListedLog>): BatteryMatch {
    val logs = run.logs.sortedByDescending { log ->
        with(log.summary.battery) { listOfNotNull(this?.resistance, this?.energy, this?.lowest).size }
    }
    val uses = logs.mapNotNull { it.summary.battery }
    val use = BatteryUse(
        uses.firstNotNullOfOrNull { it.name },
        uses.firstNotNullOfOrNull { it.topic },
        uses.mapNotNull { it.lowest }.minOrNull(),
        uses.firstNotNullOfOrNull { it.restBefore },
        uses.firstNotNullOfOrNull { it.restAfter },
        uses.firstNotNullOfOrNull { it.energy },
        uses.mapNotNull { it.resistance }.minByOrNull { it.uncertainty },
        uses.any { it.isBrownedOut },
    )
    return BatteryMatch(logs.first().title, logs.map { it.path }, run.second, use, logs.any(::counts))
}

private fun counts(log: ListedLog): Boolean = with(log.summary.match) {
    match != null && kind != MatchKind.PRACTICE
}

private fun resistancesOf(matches: List<BatteryMatch>) = matches.mapNotNull { it.use.resistance }

private fun growthIn(matches: List<BatteryMatch>): Resistance? {
    val measured = resistancesOf(matches)
    if (measured.size < MIN_FOR_GROWTH) return null
    val half = measured.size / 2
    val later = meanOf(measured.take(half)) ?: return null
    val earlier = meanOf(measured.takeLast(half)) ?: return null
    val error = sqrt(later.uncertainty * later.uncertainty + earlier.uncertainty * earlier.uncertainty)
    return Resistance(later.milliohms - earlier.milliohms, error).takeIf { it.milliohms > error }
}

private fun medianOf(values: List<Double>): Double? = values.sorted().let {
    if (it.isEmpty()) {
        null
    } else {
        (
            it[(it.size - 1) / 2] +
                it[it.size / 2]
            ) /
            2
    }
}

private const val MIN_FOR_GROWTH = 4
