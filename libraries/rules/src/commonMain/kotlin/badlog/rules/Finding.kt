package badlog.rules

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.expression.Quantity
import badlog.rules.standing.PROVEN_TRUST

/**
 * A finding of a rule or a hook in a log.
 *
 * @property rule the name of the rule or the hook.
 * @property severity how serious it is.
 * @property topic the topic it is about; null if there is none.
 * @property text the finding as a sentence: the rule's text with values filled in.
 * @property time the time to look at first, in the unit of x; NaN if it is about the whole log.
 * @property spans the spans in which it was found, at most the first [MAX_SPANS], or [MAX_PLACES] if all were requested; a moment has a
 *   span without width. Empty if it is about the whole log.
 * @property spanCount the number of times it was found.
 * @property timeUnit the unit of all times; empty if x has none.
 * @property isOfHook whether a hook found it, rather than a rule.
 * @property evidence the full names of the topics that show it, starting with the topics of the rule's condition.
 * @property next the next step, as a sentence; empty if not given.
 * @property caveats reasons to doubt it, each as a sentence: a rarely sampled topic, samples that were left out.
 * @property isForEach whether the rule runs for each of many topics, here for [topic]. A finding of the same rule about another topic is
 *   then a separate fault.
 * @property trust how far its rule can be relied on, from 0 to [PROVEN_TRUST].
 * @property meanwhile the names of the signals that were unusual nearly each time.
 * @property texts the sentence for each of [spans], with its own values; empty if [text] applies to all of them.
 */
class Finding(
    val rule: String,
    val severity: Severity,
    val topic: String?,
    val text: String,
    val time: Double,
    val spans: List<Span>,
    val spanCount: Int,
    val timeUnit: String,
    val isOfHook: Boolean = false,
    val evidence: List<String> = listOfNotNull(topic),
    val next: String = "",
    val texts: List<String> = emptyList(),
    val caveats: List<String> = emptyList(),
    val isForEach: Boolean = false,
    val trust: Double = PROVEN_TRUST,
    val meanwhile: List<String> = emptyList(),
) {
    /** Returns the sentence about [place], one of [places]. */
    fun textAt(place: Span): String = texts.getOrNull(spans.indexOf(place)) ?: text

    /** Returns the one of [places] that contains [x] or is nearest to it; null if there are none. */
    fun placeNear(x: Double): Span? = places.minByOrNull { maxOf(it.from - x, x - it.to, 0.0) }

    /** The places where it was found, starting with the one to look at first. Empty if it is about the whole log. */
    val places: List<Span>
        get() = if (time.isFinite()) spans.ifEmpty { listOf(Span(time, time)) } else emptyList()

    companion object {
        /** The maximum number of [spans] of a finding; incidents depend only on these. */
        const val MAX_SPANS: Int = 100

        /** The maximum number of [spans] if all were requested, so that a person can go through them. */
        const val MAX_PLACES: Int = 10_000
    }
}

/**
 * Returns these findings, the worst first. Within a severity, findings of more trusted rules come first, then earlier findings. Findings
 * about the whole log come before equally trusted ones with a place.
 */
fun List<Finding>.worstFirst(): List<Finding> =
    sortedWith(compareBy({ -it.severity.ordinal }, { -it.trust }, { if (it.time.isNaN()) Double.NEGATIVE_INFINITY else it.time }))

/** Returns [time] for people, such as `93.7 s`; empty if it is NaN. */
fun timeText(time: Double, unit: String): String = if (time.isNaN()) "" else Quantity("", time, unit, Double.NaN).text
