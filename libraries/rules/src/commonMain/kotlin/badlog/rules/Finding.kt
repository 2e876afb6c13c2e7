package badlog.rules

import badlog.analysis.Span
import badlog.expression.Quantity
import badlog.recording.Severity

/**
 * A rule that holds in a log, or what a hook found there.
 *
 * @property rule the rule's name, or what the hook is called.
 * @property severity how bad it is.
 * @property topic the topic it is about; null when there is none.
 * @property text what was found, as a sentence: the rule's text, filled in.
 * @property time where to look first, in the unit of x; NaN when it is about the whole log.
 * @property spans when, at most the first [MAX_SPANS], or [MAX_PLACES] where all were asked for; a moment has a span without width.
 *   Empty when it is about the whole log.
 * @property spanCount how often.
 * @property timeUnit the unit of all times, empty where x has none.
 * @property isOfHook whether a hook found it, and no rule.
 * @property evidence the full names of the topics that show it, those of the rule's condition first.
 * @property next what to look at next, as a sentence; empty where nobody says.
 * @property texts of each of [spans] what was found there, with its own figures; empty where [text] says it of all of them.
 */
public class Finding(
    public val rule: String,
    public val severity: Severity,
    public val topic: String?,
    public val text: String,
    public val time: Double,
    public val spans: List<Span>,
    public val spanCount: Int,
    public val timeUnit: String,
    public val isOfHook: Boolean = false,
    public val evidence: List<String> = listOfNotNull(topic),
    public val next: String = "",
    public val texts: List<String> = emptyList(),
) {
    /** What was found at [place], one of [places]. */
    public fun textAt(place: Span): String = texts.getOrNull(spans.indexOf(place)) ?: text

    /** The one of [places] that lasts over [x] or is nearest to it; null without any. */
    public fun placeNear(x: Double): Span? = places.minByOrNull { maxOf(it.from - x, x - it.to, 0.0) }

    /** Everywhere it was found, where to look first before the others; empty when it is about the whole log. */
    public val places: List<Span>
        get() = if (time.isFinite()) spans.ifEmpty { listOf(Span(time, time)) } else emptyList()

    public companion object {
        /** So many [spans] are kept of a finding, and decide what belongs to an incident. */
        public const val MAX_SPANS: Int = 100

        /** So many are kept for somebody who goes from one to the next. */
        public const val MAX_PLACES: Int = 10_000
    }
}

/** The worst first, and of one severity in the order of time; those about the whole log come before those with a place. */
public fun List<Finding>.worstFirst(): List<Finding> =
    sortedWith(compareBy({ -it.severity.ordinal }, { if (it.time.isNaN()) Double.NEGATIVE_INFINITY else it.time }))

/** [time] as a person reads it, such as `93.7 s`; empty when it is NaN. */
public fun timeText(time: Double, unit: String): String = if (time.isNaN()) "" else Quantity("", time, unit, Double.NaN).text
