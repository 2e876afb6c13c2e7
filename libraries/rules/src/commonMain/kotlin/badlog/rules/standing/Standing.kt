package badlog.rules.standing

import kotlin.math.floor

/** The standing of a built-in rule, which limits the severity of its findings. */
enum class Standing {
    /** Its findings may be errors or warnings, and begin incidents. */
    PROVEN,

    /** Its findings are notes, begin no incident, and come after the findings of proven rules. */
    ON_TRIAL,

    /**
     * It reports nothing, because more than one in three of its findings were wrong. For a team that sets one of its limits, it is on
     * trial.
     */
    SILENT,
    ;

    companion object {
        /** Returns the standing of a rule with this [trust]. */
        fun of(trust: Double): Standing = when {
            trust >= PROVEN_TRUST -> PROVEN
            trust >= UNCOUNTED_TRUST -> ON_TRIAL
            else -> SILENT
        }
    }
}

/** The trust in a rule that is proven, or that a team wrote for itself. */
const val PROVEN_TRUST: Double = 1.0

/** The trust in a rule that was never counted. */
const val UNCOUNTED_TRUST: Double = 0.666

/**
 * Returns the trust in a rule with these [counts], from 0 to [PROVEN_TRUST]. It is close to the share of its findings that were right.
 *
 * It is as if two right findings and a wrong one had been counted before: a rule with few findings stays near [UNCOUNTED_TRUST], and falls below it
 * exactly when more than one in three was wrong.
 */
fun trustOf(counts: List<RuleCounts>): Double {
    if (lackingIn(counts).isEmpty()) return PROVEN_TRUST
    val right = counts.sumOf { it.right }
    val judged = right + counts.sumOf { it.wrong }
    return floor(DIGITS * (right + RIGHT_BEFORE) / (judged + JUDGED_BEFORE)) / DIGITS
}

private const val RIGHT_BEFORE = 2.0
private const val JUDGED_BEFORE = 3

/** More digits say nothing, and fill pages. */
private const val DIGITS = 1000

/**
 * Returns the evidence that is still needed to prove a rule with these [counts], each as a few words. Empty if it is proven.
 *
 * A rule is proven by real logs over which it was silent or right, and by simulators in which it names the planted fault. A simulated robot shows
 * that a rule finds its fault; only real ones show that it leaves other robots alone.
 */
fun lackingIn(counts: List<RuleCounts>): List<String> {
    if (counts.isEmpty()) return listOf("its text was never counted")
    val real = counts.filter { it.set.isReal }
    val simulated = counts.filter { !it.set.isReal }
    val logs = real.sumOf { it.couldRun }
    val wrong = real.sumOf { it.wrong }
    val right = simulated.sumOf { it.right }
    val judged = right + simulated.sumOf { it.wrong }
    return listOfNotNull(
        "$logs of $MIN_LOGS real logs".takeIf { logs < MIN_LOGS },
        real.sumOf { it.teams }.let { teams -> "logs of $teams of $MIN_TEAMS teams".takeIf { teams < MIN_TEAMS } },
        "$wrong false in $logs real logs".takeIf { wrong > logs / LOGS_PER_WRONG },
        real.sumOf { it.unjudged }.let { open -> "$open not judged".takeIf { open > 0 } },
        "$right of $judged right in simulators".takeIf { right * PERCENT < judged * MIN_PERCENT_RIGHT },
        (right + real.sumOf { it.right }).let { all -> "right $all of $MIN_RIGHT times".takeIf { all < MIN_RIGHT } },
    )
}

/** Fewer logs show little about robots in general. */
private const val MIN_LOGS = 30
private const val MIN_TEAMS = 3

/** One false finding is allowed for as many real logs. */
private const val LOGS_PER_WRONG = 200
private const val PERCENT = 100
private const val MIN_PERCENT_RIGHT = 95

/** The least number of findings that must be right, over all sets. A rule that is always silent is never wrong, and proves nothing. */
private const val MIN_RIGHT = 3
