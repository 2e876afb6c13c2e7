package badlog.analysis

import badlog.recording.Topic

/**
 * One line of a graph.
 *
 * @property name what the legend calls it.
 * @property unit its unit, `ul` for none.
 * @property topic the topic it comes from.
 * @property isDerived whether its samples were calculated from those of [topic] rather than logged.
 * @property states what each number means, where the numbers only stand for states: state `n` is `states[n]`. Else null.
 */
public class GraphSeries internal constructor(
    public val name: String,
    public val unit: String,
    public val topic: Topic,
    public val states: List<String>?,
    public val isDerived: Boolean = false,
    compute: () -> Series,
) {
    /** Its samples, computed when they are first asked for. */
    public val data: Series by lazy(compute)

    /** Whether a sample's value holds until the next one: that of a topic with times of its own, logged when it changes. */
    public val holds: Boolean get() = topic.times != null && !isDerived
}
