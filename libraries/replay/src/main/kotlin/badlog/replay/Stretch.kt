package badlog.replay

import kotlin.math.roundToLong

/**
 * A part of a recording that was played without a jump: what stands after [from] and not after [to].
 *
 * @property isFresh whether the playhead jumped to [from], so that what holds there is news.
 */
internal class Stretch(
    val from: Double,
    val to: Double,
    val isFresh: Boolean,
    private val anchorPosition: Double,
    private val anchorNanos: Long,
    private val unitsPerNano: Double,
) {
    /** When the playhead was at [position]. */
    fun nanosAt(position: Double): Long = anchorNanos + ((position - anchorPosition) / unitsPerNano).roundToLong()
}
