package badlog.replay

import badlog.analysis.Series
import badlog.analysis.Units

/**
 * What is shown as one topic of NetworkTables.
 *
 * @property name its whole name there; begins with `/`.
 * @property unit its unit, or null for none.
 * @property samples its values; ordered, and without gaps but for a [SignalType.DOUBLE], of which NaN tells that there is
 *   no number from then on.
 * @property texts what the samples of a [SignalType.STRING] stand for, in UTF-8; else empty.
 */
internal class Signal(
    val name: String,
    val type: SignalType,
    unit: String,
    val samples: Series,
    val texts: List<ByteArray> = emptyList(),
) {
    val unit: String? = unit.takeUnless(Units::isNone)

    /** How many samples stand at or before [position]. */
    fun countUntil(position: Double): Int = samples.firstAtOrAfter(Math.nextUp(position))
}
