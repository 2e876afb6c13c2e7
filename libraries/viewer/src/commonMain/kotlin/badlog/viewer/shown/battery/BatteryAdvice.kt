package badlog.viewer.shown.battery

import badlog.signals.battery.Resistance
import badlog.viewer.text.fixedText
import kotlin.math.floor
import kotlin.math.roundToInt

/**
 * The advice on a team's batteries.
 *
 * @property next the battery to use next, with the reason; null if no log has a battery of the team.
 * @property retire the batteries to retire, with the reasons.
 * @property charge the batteries that were not full, with the evidence.
 */
class BatteryAdvice private constructor(val next: AdvisedBattery?, val retire: List<AdvisedBattery>, val charge: List<AdvisedBattery>) {
    /** The whole advice in order: the battery to use next, the ones to retire, the ones to check. */
    val all: List<AdvisedBattery> get() = listOfNotNull(next) + retire + charge

    /** The most important advice, as much as a pit view has room for. */
    val inPit: List<AdvisedBattery> get() = all.take(MAX_IN_PIT)

    /** Returns the advice on the battery of [season]; null if there is none. */
    fun of(season: BatterySeason): AdvisedBattery? = all.find { it.name == season.battery?.name }

    companion object {
        /** Returns the advice on the batteries with these [seasons]. */
        fun of(seasons: List<BatterySeason>): BatteryAdvice {
            val inUse = seasons.filter { it.battery?.isRetired == false }
            val best = inUse.filter { it.resistance != null }.minByOrNull { highOf(it.resistance!!) }
            val retire = inUse.mapNotNull { retired(it, best) }
            val charge = inUse.mapNotNull { brownedOut(it) ?: notFull(it) }.filter { tired -> retire.none { it.name == tired.name } }
            val usable = inUse.filter { season -> retire.none { it.name == season.title } && brownedOut(season) == null }
            val fit = usable.filter { season -> charge.none { it.name == season.title } }.ifEmpty { usable }
            return BatteryAdvice(if (inUse.all { it.matches.isEmpty() }) null else nextOf(fit, seasons, best), retire, charge)
        }

        private fun retired(season: BatterySeason, best: BatterySeason?): AdvisedBattery? {
            val own = season.resistance?.takeIf { season !== best } ?: return null
            val least = best?.resistance ?: return null
            // One match does not show how much matches differ.
            if (season.matches.count { it.use.resistance != null } < MIN_TO_RETIRE) return null
            // A worn battery's voltage drops a third more at the same current.
            if (own.milliohms - own.uncertainty <= highOf(least) * WORN) return null
            val more = ((own.milliohms / least.milliohms - 1) * PERCENT).roundToInt()
            val reason = "Its resistance is ${resistanceText(own)}, $more % more than that of ${best.title} (${resistanceText(least)})."
            return AdvisedBattery(season.title, BatteryStep.RETIRE, reason)
        }

        /** Whether it fell so low in its last match that the roboRIO switched motors off. */
        private fun brownedOut(season: BatterySeason): AdvisedBattery? {
            val match = season.matches.firstOrNull()?.takeIf { it.use.isBrownedOut } ?: return null
            return AdvisedBattery(season.title, BatteryStep.CHECK, "The robot browned out with it in ${match.title}.", "")
        }

        private fun notFull(season: BatterySeason): AdvisedBattery? {
            val last = season.matches.filter { it.isMatch && it.use.restBefore != null }.take(MATCHES_TO_TELL)
            if (last.size < MATCHES_TO_TELL || last.any { it.use.restBefore!! >= FULL }) return null
            // Rounded down, so that a battery does not seem to be full.
            val texts = last.map { floor(it.use.restBefore!! * HUNDREDTHS) / HUNDREDTHS }.sorted().map(::voltsText)
            val between = if (texts.first() == texts.last()) texts.first() else "${texts.first()} to ${texts.last()}"
            val before = "Before its last $MATCHES_TO_TELL matches it rested at $between"
            return AdvisedBattery(
                season.title,
                BatteryStep.CHECK,
                "$before; a full battery has ${voltsText(FULL)} or more.",
            )
        }

        /**
         * Returns the battery to use next. It is the one that rested longest of the [fit] ones no worse than the [best] known one, or else
         * than the best of them. One that was never measured is used only if there is no other.
         */
        private fun nextOf(fit: List<BatterySeason>, all: List<BatterySeason>, best: BatterySeason?): AdvisedBattery? {
            val last = all.maxByOrNull { it.lastUse }
            val others = fit.filter { it !== last }
            val offered = others.ifEmpty { fit }
            val least = offered.mapNotNull { it.resistance }.minByOrNull(::highOf)
            val good = listOfNotNull(best?.resistance, least).map { measure -> offered.filter { isAsGood(it, measure) } }
            val next = (good.firstOrNull { it.isNotEmpty() } ?: offered).minByOrNull { it.lastUse } ?: return null
            val match = next.matches.firstOrNull()
            val isUnknownSince = all.any { it.battery == null && match != null && it.lastUse > match.second }
            val reasons = listOfNotNull(
                resistanceOf(next, best),
                when {
                    match == null -> "no log has it yet"
                    others.isEmpty() -> "it is the only usable one"
                    isUnknownSince -> "no log after ${match.title} names it"
                    else -> "it has rested since ${match.title}"
                },
            )
            return AdvisedBattery(
                next.title,
                BatteryStep.USE,
                reasons.joinToString(" and ", postfix = ".").replaceFirstChar {
                    it.uppercase()
                },
            )
        }

        /** Says the resistance of [season], compared with the [best]; null for a battery that no log has. */
        private fun resistanceOf(season: BatterySeason, best: BatterySeason?): String? {
            val own = season.resistance ?: return if (season.matches.isEmpty()) null else "its resistance was not measured"
            val least = best?.resistance ?: return null
            val other = if (isAsGood(season, least)) "" else " (${best.title}: ${resistanceText(least)})"
            return "its resistance is ${resistanceText(own)}$other"
        }

        private fun isAsGood(season: BatterySeason, measure: Resistance) =
            season.resistance?.let { it.milliohms - it.uncertainty <= highOf(measure) } ?: false

        private val BatterySeason.lastUse: Long get() = matches.firstOrNull()?.second ?: Long.MIN_VALUE

        private fun highOf(resistance: Resistance) = resistance.milliohms + resistance.uncertainty

        private const val PERCENT = 100

        private const val WORN = 4.0 / 3

        /** The voltage at rest of a nearly full lead battery, in volts, with the robot's computers on. */
        private const val FULL = 12.4
        private const val MATCHES_TO_TELL = 3
        private const val HUNDREDTHS = 100
        private const val MIN_TO_RETIRE = 2
        private const val MAX_IN_PIT = 3
    }
}

/**
 * The advice on one battery.
 *
 * @property name the name of the battery.
 * @property reason the reason, as a sentence.
 */
class AdvisedBattery(val name: String, val step: BatteryStep, val reason: String, private val after: String = step.after) {
    /** The advice in a few words: `Use A1 next`. */
    val headline: String get() = step.before + name + after

    /** The advice among others that are not about batteries: `Battery: use A1 next`. */
    val pitText: String get() = "Battery: ${headline.replaceFirstChar { it.lowercase() }}"

    /** The advice with its reason, as sentences. */
    val text: String get() = "$headline. $reason"
}

/**
 * An action for a battery.
 *
 * @property label the label beside a battery.
 */
enum class BatteryStep(val label: String, internal val before: String, internal val after: String = "") {
    /** Use the battery for the next match. */
    USE("Use next", "Use ", " next"),

    /** Do not use the battery in matches any more. */
    RETIRE("Retire", "Retire "),

    /** Check the battery: it was not full, or does not hold its charge. */
    CHECK("Check", "Check ", " and its charger"),
}

/** Returns [resistance] with its uncertainty, such as `20.7 ± 0.4 mΩ`. */
fun resistanceText(resistance: Resistance): String =
    "${fixedText(resistance.milliohms, 1)} ± ${fixedText(maxOf(resistance.uncertainty, MIN_SHOWN), 1)} mΩ"

internal fun voltsText(volts: Double): String = "${fixedText(volts, 2)} V"

/** The smallest shown uncertainty: no resistance is known more precisely. */
private const val MIN_SHOWN = 0.1
