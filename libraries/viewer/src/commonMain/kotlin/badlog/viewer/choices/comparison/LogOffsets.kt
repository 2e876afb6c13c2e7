package badlog.viewer.choices.comparison

import badlog.viewer.text.exactText
import kotlin.math.abs
import kotlin.math.round

/**
 * The offset of each compared log on x. Immutable; each transition returns a new one.
 *
 * @param K the identity of a log.
 * @property alignment the aligned moment.
 * @property byHand the manual offset of each log, in units of x; only differences between them matter, and a missing log has 0.
 */
data class LogOffsets<K>(val alignment: Alignment = Alignment.START, val byHand: Map<K, Double> = emptyMap()) {
    /** Returns the number to add to the x of [log] so that it is aligned with [open]; always finite. [moments] contains both logs. */
    fun of(log: K, open: K, moments: Map<K, LogMoments>): Double {
        if (log == open) return 0.0
        val isByHand = alignment == Alignment.MANUAL
        val offset = if (isByHand) handOffset(log) - handOffset(open) else momentIn(moments[open]) - momentIn(moments[log])
        return if (offset.isFinite()) offset else 0.0
    }

    /** Aligns by [wanted]. For manual alignment, each log in [moments] stays where it is relative to [open]. */
    fun alignedBy(wanted: Alignment, open: K, moments: Map<K, LogMoments>): LogOffsets<K> {
        val isFirstByHand = wanted == Alignment.MANUAL && alignment != Alignment.MANUAL
        return LogOffsets(wanted, if (isFirstByHand) moments.keys.associateWith { of(it, open, moments) } else byHand)
    }

    /**
     * Moves [log] to [offset] relative to [open], which makes the alignment manual. The offset is rounded to six decimals, and ignored if
     * it is not finite.
     */
    fun moved(log: K, offset: Double, open: K, moments: Map<K, LogMoments>): LogOffsets<K> {
        if (!offset.isFinite() || log == open) return this
        val byHand = alignedBy(Alignment.MANUAL, open, moments)
        return byHand.copy(byHand = byHand.byHand + (log to byHand.handOffset(open) + rounded(offset)))
    }

    /** Forgets the manual offset of [log]. */
    fun without(log: K): LogOffsets<K> = copy(byHand = byHand.filterKeys { it != log })

    private fun handOffset(log: K) = byHand[log] ?: 0.0

    private fun momentIn(moments: LogMoments?): Double = when (alignment) {
        Alignment.START -> moments?.first ?: 0.0
        Alignment.ENABLED -> moments?.enabled ?: moments?.first ?: 0.0
        Alignment.NONE, Alignment.MANUAL -> 0.0
    }
}

/** Returns the number that a person has typed as an offset, with a comma or a point. Null if it is not a number. */
fun offsetOf(text: String): Double? = text.trim().replace(',', '.').toDoubleOrNull()?.takeIf { it.isFinite() }

/** Returns [offset] as the text that [offsetOf] reads, without the rounding errors of steps. */
fun offsetText(offset: Double): String = exactText(rounded(offset))

/**
 * A step by which a click moves a log.
 *
 * @property by the length of the step, in units of x; negative to the left.
 */
class OffsetStep(val by: Double) {
    private val distance = (if (by < 0) "-" else "+") + exactText(abs(by))

    /** The label of its button, such as `+.1`. */
    val label: String get() = distance.replace("0.", ".")

    /** Returns a description of the step for the log called [name]. */
    fun hintFor(name: String): String = "Move $name by $distance"
}

/** The steps that front ends offer, from the longest to the left to the longest to the right. */
val OFFSET_STEPS: List<OffsetStep> = listOf(-1.0, -0.1, -0.02, 0.02, 0.1, 1.0).map(::OffsetStep)

private fun rounded(offset: Double) = round(offset * MILLION) / MILLION

private const val MILLION = 1e6

/**
 * The moment by which compared logs are aligned; it is at the same x in all of them.
 *
 * @property title the label.
 * @property hint the effect, as a sentence.
 * @property layoutName the name in layout files; must never change.
 */
enum class Alignment(val title: String, val hint: String, val layoutName: String) {
    /** The first x. */
    START("Start", "Every log starts where the open one starts.", "START"),

    /** The first moment at which the robot was enabled; the first x if that is unknown. */
    ENABLED(
        "Enabled",
        "The robot is first enabled at the same time in all logs; a log without that time starts with the open one.",
        "ENABLED",
    ),

    /** The logged x. */
    NONE("No alignment", "Every log keeps its own x.", "AS_LOGGED"),

    /** The place to which a person moved the log. */
    MANUAL("Manual", "You move each log yourself.", "BY_HAND"),
}

/**
 * The moments of a log by which it can be aligned, as x.
 *
 * @property first the smallest x.
 * @property enabled the moment when the robot was first enabled; null if unknown.
 */
class LogMoments(val first: Double, val enabled: Double?)
