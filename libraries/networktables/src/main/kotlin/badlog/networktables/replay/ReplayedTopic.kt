package badlog.networktables.replay

import badlog.core.analysis.Series
import badlog.core.analysis.Units
import badlog.networktables.TopicType

/**
 * One topic of NetworkTables.
 *
 * @property name its full name there; begins with `/`.
 * @property unit its unit, or null for none.
 * @property samples its values; ordered, and without gaps, except for a [TopicType.DOUBLE], for which NaN means that there is no number
 *   from then on.
 * @property texts the texts for the samples of a [TopicType.STRING], in UTF-8; otherwise empty.
 * @property typeName the name of the type in its announcement.
 * @property payload returns the bytes of a sample, as in a WPILOG; null if numbers are sent instead.
 */
internal class ReplayedTopic(
    val name: String,
    val type: TopicType,
    unit: String,
    val samples: Series,
    val texts: List<ByteArray> = emptyList(),
    val typeName: String = type.typeName,
    val payload: ((index: Int) -> ByteArray)? = null,
) {
    val unit: String? = unit.takeUnless(Units::isNone)

    /** Returns the number of samples at or before [position]. */
    fun countUntil(position: Double): Int = samples.firstAtOrAfter(Math.nextUp(position))
}

/** Returns these samples in the order of x; samples with equal x keep their order. */
internal fun Series.ordered(): Series {
    if (isOrdered) return this
    val order = (0 until size).sortedBy { x[it] }
    return Series(DoubleArray(size) { x[order[it]] }, DoubleArray(size) { y[order[it]] })
}

/** Returns these samples with at most the first NaN of each gap. That is removed, too, if [keepsFirst] is false or nothing precedes it. */
internal fun Series.withoutGaps(keepsFirst: Boolean): Series {
    fun isKept(i: Int) = !y[i].isNaN() || (keepsFirst && i > 0 && !y[i - 1].isNaN())
    val kept = (0 until size).count(::isKept)
    if (kept == size) return this
    val keptX = DoubleArray(kept)
    val keptY = DoubleArray(kept)
    var at = 0
    for (i in 0 until size) {
        if (!isKept(i)) continue
        keptX[at] = x[i]
        keptY[at++] = y[i]
    }
    return Series(keptX, keptY)
}
