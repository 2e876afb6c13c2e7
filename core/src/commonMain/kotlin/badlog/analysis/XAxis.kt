package badlog.analysis

import badlog.recording.PathName
import badlog.recording.Recording
import badlog.recording.Topic

/**
 * The common x of a recording's graphs.
 *
 * @property name what it is called: the base name of the topic with the `xaxis` attribute, `Time` where there are no rows and
 *   topics have times of their own, else `Index`.
 * @property unit its unit, `ul` for none.
 * @property positions the x of each row; may hold gaps, and may go backwards. Empty where there are no rows. Not to be
 *   changed.
 * @property topic the topic it comes from, or null for the row index and for times of their own.
 */
public class XAxis private constructor(
    public val name: String,
    public val unit: String,
    public val positions: DoubleArray,
    public val topic: Topic?,
    private val ownTimes: List<DoubleArray>,
) {
    /** What stands below the graphs: `Name (unit)`, or the name alone without a unit. */
    public val title: String get() = if (Units.isNone(unit)) name else "$name ($unit)"

    /** Whether x only counts rows. */
    public val isIndex: Boolean get() = topic == null && name == INDEX

    /** Every x of the recording: [positions] where there are rows, and an array for each clock of its topics, in which x ascends. */
    public val clocks: List<DoubleArray>
        get() = if (positions.isEmpty() && ownTimes.isNotEmpty()) ownTimes else listOf(positions) + ownTimes

    /** Whether each row has an x. */
    internal val isEverywhere: Boolean by lazy { positions.all { it.isFinite() } }

    private val usual by lazy { UsualRange(positions) }

    /** How many of [positions] lie so far from all others that [range] leaves them out. */
    public val wildCount: Int get() = usual.wildCount

    /** The one of those that is farthest away; NaN without any. */
    public val wildest: Double get() = usual.wildest

    /**
     * The smallest and the largest x at which there is a sample; null without any. A few that are far away from all others, as when a
     * clock was wrong for a moment, are left out: else nothing could be seen of these.
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

        /** The x axis that [topic], one of those of [recording], gives. */
        internal fun of(topic: Topic, recording: Recording): XAxis =
            XAxis(PathName.baseNameOf(topic.name), topic.unit, topic.samples, topic, ownTimesOf(recording))

        /** The index of each row of [recording], from 0. */
        internal fun index(recording: Recording): XAxis {
            val positions = DoubleArray(recording.rowCount) { it.toDouble() }
            return XAxis(INDEX, Topic.UNITLESS, positions, null, ownTimesOf(recording))
        }

        /** Time, where [recording] has no rows but topics with times of their own; else null. */
        internal fun ofOwnTimes(recording: Recording): XAxis? {
            val clocks = if (recording.rowCount == 0) ownTimesOf(recording) else emptyList()
            return if (clocks.isEmpty()) null else XAxis("Time", "s", DoubleArray(0), null, clocks)
        }

        private fun ownTimesOf(recording: Recording): List<DoubleArray> {
            // Arrays are equal only to themselves.
            val clocks = LinkedHashSet<DoubleArray>()
            for (topic in recording.topics) topic.times?.let { clocks += it }
            return clocks.toList()
        }
    }
}
