package badlog.analysis

import badlog.recording.PathName
import badlog.recording.Topic

/**
 * What happened, in the order of the file.
 *
 * @property topic the topic it comes from.
 */
public class EventLog internal constructor(public val topic: Topic, private val xAxis: XAxis) {
    /** The full name, with its folder. */
    public val name: String get() = topic.name

    /** What stands above it. */
    public val title: String get() = PathName.baseNameOf(topic.name)

    /** Each text cell of the topic; numbers and empty cells are no events. */
    public val events: List<Event> by lazy(LazyThreadSafetyMode.NONE) {
        val texts = topic.texts
        List(texts.size) { i ->
            val row = texts.rows[i]
            Event(xAxis.positions.getOrElse(row) { Double.NaN }, row, texts[i])
        }
    }
}
