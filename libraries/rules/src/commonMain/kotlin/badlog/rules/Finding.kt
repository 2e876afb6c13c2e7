package badlog.rules

import badlog.analysis.Span
import badlog.expression.Quantity
import badlog.recording.Severity

/**
 * What a rule or a hook found in a log.
 *
 * @property rule the name of the rule or the hook.
 * @property severity how serious it is.
 * @property topic the topic it is about; null if there is none.
 * @property text what was found, as a sentence: the rule's text with values filled in.
 * @property time where to look first, in the unit of x; NaN if it is about the whole log.
 * @property spans when it was found, at most the first [MAX_SPANS], or [MAX_PLACES] if all were requested; a moment has a span
 *   without width. Empty if it is about the whole log.
 * @property spanCount how often it was found.
 * @property timeUnit the unit of all times; empty if x has none.
 * @property isOfHook whether a hook found it, rather than a rule.
 * @property evidence the full names of the topics that show it, those of the rule's condition first.
 * @property next what to look at next, as a sentence; empty if not given.
 * @property texts for each of [spans], what was found there, with its own values; empty if [text] applies to all of them.
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
    /** Returns what was found at [place], one of [places]. */
    public fun textAt(place: Span): String = texts.getOrNull(spans.indexOf(place)) ?: text

    /** Returns the one of [places] that lasts over [x] or is nearest to it; null if there are none. */
    public fun placeNear(x: Double): Span? = places.minByOrNull { maxOf(it.from - x, x - it.to, 0.0) }

    /** All places where it was found, the one to look at first before the others; empty if it is about the whole log. */
    public val places: List<Span>
        get() = if (time.isFinite()) spans.ifEmpty { listOf(Span(time, time)) } else emptyList()

    public companion object {
        /** The maximum number of [spans] of a finding, which also decide what belongs to an incident. */
        public const val MAX_SPANS: Int = 100

        /** The maximum number of places that a person can go through. */
        public const val MAX_PLACES: Int = 10_000
    }
}

/**
 * Returns the findings, the worst first, and within a severity in the order of time; those about the whole log come before those with a
 * place.
 */
public fun List<Finding>.worstFirst(): List<Finding> =
    sortedWith(compareBy({ -it.severity.ordinal }, { if (it.time.isNaN()) Double.NEGATIVE_INFINITY else it.time }))

/** Returns [time] for people, such as `93.7 s`; empty if it is NaN. */
public fun timeText(time: Double, unit: String): String = if (time.isNaN()) "" else Quantity("", time, unit, Double.NaN).text
