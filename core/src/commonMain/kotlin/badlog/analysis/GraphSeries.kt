package badlog.analysis

import badlog.recording.Topic

/**
 * One line of a graph.
 *
 * @property name what the legend calls it.
 * @property unit its unit, `ul` for none.
 * @property topic the topic it comes from.
 * @property states what each number means, where the numbers only stand for states: state `n` is `states[n]`. Else null.
 */
public class GraphSeries internal constructor(
    public val name: String,
    public val unit: String,
    public val topic: Topic,
    public val states: List<String>?,
    compute: () -> Series,
) {
    /** Its samples, computed when they are first asked for. */
    public val data: Series by lazy(compute)
}
