package badlog.analysis

import badlog.recording.PathName
import badlog.recording.Topic

/**
 * The common x of a recording's graphs.
 *
 * @property name what it is called: the base name of the topic with the `xaxis` attribute, else `Index`.
 * @property unit its unit, `ul` for none.
 * @property positions the x of each row; may hold gaps, and may go backwards. Not to be changed.
 * @property topic the topic it comes from, or null for the row index.
 */
public class XAxis private constructor(
    public val name: String,
    public val unit: String,
    public val positions: DoubleArray,
    public val topic: Topic?,
) {
    /** What stands below the graphs: `Name (unit)`, or the name alone without a unit. */
    public val title: String get() = if (Units.isNone(unit)) name else "$name ($unit)"

    public companion object {
        /** The x axis that [topic] gives. */
        internal fun of(topic: Topic): XAxis = XAxis(PathName.baseNameOf(topic.name), topic.unit, topic.samples, topic)

        /** The index of each of [rowCount] rows, from 0. */
        internal fun index(rowCount: Int): XAxis =
            XAxis("Index", Topic.UNITLESS, DoubleArray(rowCount) { it.toDouble() }, null)
    }
}
