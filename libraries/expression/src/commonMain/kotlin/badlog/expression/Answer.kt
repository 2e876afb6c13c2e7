package badlog.expression

import badlog.core.analysis.Span
import badlog.core.analysis.Units

/**
 * The result of an [Expression] for one recording.
 *
 * @property outcome whether the expression holds.
 * @property spans the times at which a condition over time holds, or the conditions inside `any`, `count` and `total`. They do not touch
 *   and are in the order of time, unless the clock was set back; a span is cut there. Something that happens at a moment has a span without
 *   width. Empty for a number for the whole recording.
 * @property times the number of [spans]; one that was cut counts once.
 * @property quantities the numbers that were compared, in the order of the expression; for one over time, the most significant one while
 *   the expression holds: the smallest for `<`, the largest for `>`, otherwise the first. For an expression that is a number, the number;
 *   for one over time, its smallest and its largest, as `min(…)` and `max(…)`.
 * @property timeUnit the unit of all times; empty if x has none.
 * @property reason why the answer is not known, as a sentence; null if it is known, or if samples are missing.
 * @property occurrences one for each of [spans], with the values just before, if the question asks for them; otherwise empty.
 */
class Answer internal constructor(
    val outcome: Outcome,
    val spans: List<Span>,
    val times: Int,
    val quantities: List<Quantity>,
    val timeUnit: String,
    val reason: String? = null,
    val occurrences: List<Occurrence> = emptyList(),
    private val firstOver: (List<Span>) -> List<Quantity?> = { spans -> spans.map { null } },
) {
    /**
     * Returns the first of [quantities] within each span of [some], a selection of [spans], in order. A result is null if the quantity does
     * not belong to a condition over time, or if the span has no sample.
     */
    fun firstQuantityOver(some: List<Span>): List<Quantity?> = firstOver(some)

    /** Whether the expression holds. */
    val matches: Boolean get() = outcome == Outcome.HOLDS

    /** The time to look at first: the start of the first span, or otherwise the time of the first quantity. NaN if neither exists. */
    val time: Double
        get() = if (spans.isNotEmpty()) spans[0].from else quantities.firstOrNull { !it.time.isNaN() }?.time ?: Double.NaN

    /** Returns the answer in one line. Examples are `yes, min(Battery Voltage) = 6.7 V at 93.74 s` and `yes, from 92 s to 97.2 s`. */
    override fun toString(): String {
        val parts = ArrayList<String>()
        when (outcome) {
            Outcome.HOLDS -> parts += "yes"
            Outcome.FAILS -> parts += "no"
            Outcome.UNKNOWN -> parts += "not known"
            Outcome.NO_QUESTION -> {}
        }
        quantities.mapTo(parts) { if (it.time.isNaN()) it.toString() else "$it at ${timed(it.time)}" }
        if (spans.isNotEmpty()) {
            val first = spans[0]
            parts += if (first.width == 0.0) "at ${timed(first.from)}" else "from ${timed(first.from)} to ${timed(first.to)}"
            if (times > 1) parts += if (times == 2) "and once more" else "and ${times - 1} more times"
            if (spans.size > times) parts += "in ${spans.size} parts since the clock was set back"
        }
        return parts.joinToString(", ")
    }

    private fun timed(time: Double) = if (Units.isNone(timeUnit)) readable(time) else "${readable(time)} $timeUnit"
}

/**
 * One occurrence of something.
 *
 * @property span when it happened.
 * @property before the values just before it: each requested expression as written, with its number and unit, or its text.
 */
class Occurrence(val span: Span, val before: List<Pair<String, String>>)

/** The outcome of a question. */
enum class Outcome {
    /** Yes: it holds, at least at some time. */
    HOLDS,

    /** No. */
    FAILS,

    /** Not known, because the necessary samples are missing. */
    UNKNOWN,

    /** The expression is a number rather than a question; see [Answer.quantities]. */
    NO_QUESTION,
}
