package badlog.expression

import badlog.analysis.Span
import badlog.analysis.Units

/**
 * What an [Expression] came to over one recording.
 *
 * @property outcome whether it holds.
 * @property spans when it holds, in the order in which it did: of a condition over time, and of those that `any`, `count` and
 *   `total` speak of. They are apart from each other and in the order of time, unless the clock was set back; a span over which
 *   it was is cut there. Something that happens at a moment has a span without width. Empty for a figure of the whole recording.
 * @property times how often it holds: the number of [spans], but one that was cut counts once.
 * @property quantities the numbers that were compared, in the order of the expression; of one over time the most telling while
 *   the expression holds: the smallest for `<`, the largest for `>`, else the first. Of an expression that is a number, the
 *   number; of one over time, its smallest and its largest, as `min(…)` and `max(…)`.
 * @property timeUnit the unit of all times, empty where x has none.
 * @property reason why it is not known, as a sentence; null where it is known, or where samples are missing.
 * @property occurrences one for each of [spans] where the question asks for them, with what was just before; else empty.
 */
public class Answer internal constructor(
    public val outcome: Outcome,
    public val spans: List<Span>,
    public val times: Int,
    public val quantities: List<Quantity>,
    public val timeUnit: String,
    public val reason: String? = null,
    public val occurrences: List<Occurrence> = emptyList(),
    private val firstOver: (List<Span>) -> List<Quantity?> = { spans -> spans.map { null } },
) {
    /**
     * The first of [quantities] as it was over each of [some] of the [spans] alone, in their order; null where it is not of a condition
     * over time, and where it has no sample there.
     */
    public fun firstQuantityOver(some: List<Span>): List<Quantity?> = firstOver(some)

    /** Whether the expression holds. */
    public val matches: Boolean get() = outcome == Outcome.HOLDS

    /** Where to look first: the start of the first span, else where the first figure was found; NaN when neither exists. */
    public val time: Double
        get() = if (spans.isNotEmpty()) spans[0].from else quantities.firstOrNull { !it.time.isNaN() }?.time ?: Double.NaN

    /** In a line, such as `yes, min(Battery Voltage) = 6.7 V at 93.74 s` or `yes, from 92 s to 97.2 s`. */
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
 * One time that something happened.
 *
 * @property span when.
 * @property before what was just before it: what was asked for, as it was written, and its number with its unit, or its text.
 */
public class Occurrence(public val span: Span, public val before: List<Pair<String, String>>)

/** What the answer to a question is. */
public enum class Outcome {
    /** Yes: it holds, or does at some time. */
    HOLDS,

    /** No. */
    FAILS,

    /** Not known, since samples are missing that would tell. */
    UNKNOWN,

    /** The expression was not a question but a number; see [Answer.quantities]. */
    NO_QUESTION,
}
