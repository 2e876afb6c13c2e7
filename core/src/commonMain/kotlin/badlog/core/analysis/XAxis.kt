package badlog.core.analysis

import badlog.core.recording.PathName
import badlog.core.recording.Recording
import badlog.core.recording.Topic

/**
 * The common x of a recording's graphs.
 *
 * @property name its name: the base name of the topic with the `xaxis` attribute; `Time` if there are no rows and topics have times of
 *   their own; otherwise `Index`.
 * @property unit its unit, `ul` for none.
 * @property positions the x of each row; may have gaps, and may go backwards. Empty if there are no rows. Do not change this array.
 * @property topic the topic with the values of x; null for the row index and for topics' own times.
 */
public class XAxis private constructor(
    public val name: String,
    public val unit: String,
    public val positions: DoubleArray,
    public val topic: Topic?,
    private val ownTimes: List<DoubleArray>,
) {
    /** The text below the graphs: `Name (unit)`, or just the name if there is no unit. */
    public val title: String get() = if (Units.isNone(unit)) name else "$name ($unit)"

    /** Whether x is only the number of the row. */
    public val isIndex: Boolean get() = topic == null && name == INDEX

    /** All arrays of x in the recording. They are [positions] if there are rows, and an ascending array for each clock of its topics. */
    public val clocks: List<DoubleArray>
        get() = if (positions.isEmpty() && ownTimes.isNotEmpty()) ownTimes else listOf(positions) + ownTimes

    /** Whether each row has an x. */
    internal val isEverywhere: Boolean by lazy { positions.all { it.isFinite() } }

    private val usual by lazy { UsualRange(positions) }

    /** The number of [positions] that [range] leaves out because they are far from all others. */
    public val wildCount: Int get() = usual.wildCount

    /** The farthest of the positions that [range] does not include; NaN if there are none. */
    public val wildest: Double get() = usual.wildest

    /**
     * The smallest and the largest x with a sample; null if there are none. A few positions far away from all others are ignored, such as
     * those from a clock that was wrong for a moment. They would make the others too small to see.
     */
    public val range: ClosedFloatingPointRange<Double>? by lazy {
        var from = usual.range?.start ?: Double.POSITIVE_INFINITY
        var to = usual.range?.endInclusive ?: Double.NEGATIVE_INFINITY
        for (times in ownTimes) {
            if (times.isEmpty()) continue
            from = minOf(from, times.first())
            to = maxOf(to, times.last())
        }
        if (from <= to) from..to else null
    }

    public companion object {
        private const val INDEX = "Index"

        /** Returns the x axis made from [topic], which is in [recording]. */
        internal fun of(topic: Topic, recording: Recording): XAxis =
            XAxis(PathName.baseNameOf(topic.name), topic.unit, topic.samples, topic, ownTimesOf(recording))

        /** Returns the index of each row of [recording], from 0, as an x axis. */
        internal fun index(recording: Recording): XAxis {
            val positions = DoubleArray(recording.rowCount) { it.toDouble() }
            return XAxis(INDEX, Topic.UNITLESS, positions, null, ownTimesOf(recording))
        }

        /** Returns time as the x axis if [recording] has no rows but topics with times of their own; otherwise null. */
        internal fun ofOwnTimes(recording: Recording): XAxis? {
            val clocks = if (recording.rowCount == 0) ownTimesOf(recording) else emptyList()
            return if (clocks.isEmpty()) null else XAxis("Time", "s", DoubleArray(0), null, clocks)
        }

        private fun ownTimesOf(recording: Recording): List<DoubleArray> {
            // Arrays are equal only to themselves, so each clock is in the set once.
            val clocks = LinkedHashSet<DoubleArray>()
            for (topic in recording.topics) topic.times?.let { clocks += it }
            return clocks.toList()
        }
    }
}
