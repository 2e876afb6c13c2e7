package badlog.core.analysis

import badlog.core.recording.Topic

/**
 * One line of a graph.
 *
 * @property name its name in the legend.
 * @property unit its unit, `ul` for none.
 * @property topic the topic it comes from.
 * @property isDerived whether its samples were calculated from [topic]'s samples rather than logged.
 * @property states the names of the states, if the numbers only stand for states: number `n` is `states[n]`. Otherwise
 * null.
 * @param range returns the part of x in which its recording has samples, see [recorded].
 */
public class GraphSeries internal constructor(
    public val name: String,
    public val unit: String,
    public val topic: Topic,
    public val states: List<String>?,
    public val isDerived: Boolean = false,
    private val range: () -> ClosedFloatingPointRange<Double>?,
    compute: () -> Series,
) {
    /** Its samples, computed on first use. */
    public val data: Series by lazy(compute)

    /** Whether a sample's value holds until the next one. True for a topic with times of its own, which is logged when it changes. */
    public val holds: Boolean get() = topic.times != null && !isDerived

    /**
     * The range of x in which its recording has samples, even if this line has none there. If values hold, the last one holds until the
     * range ends. Null if there are no samples.
     */
    public val recorded: ClosedFloatingPointRange<Double>? get() = range()

    /**
     * Returns this line with [offset] added to each x, and [suffix] to its name and its topic's. The line can then be drawn among the lines
     * of another log. [offset] is in the unit of x; the times of the topic itself are unchanged.
     */
    public fun moved(offset: Double, suffix: String): GraphSeries = GraphSeries(
        name + suffix,
        unit,
        topic.copy(name = topic.name + suffix),
        states,
        isDerived,
        { recorded?.let { it.start + offset..it.endInclusive + offset } },
    ) {
        if (offset == 0.0) data else Series(DoubleArray(data.size) { data.x[it] + offset }, data.y)
    }
}
