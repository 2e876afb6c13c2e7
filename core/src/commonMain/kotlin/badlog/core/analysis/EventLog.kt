package badlog.core.analysis

import badlog.core.recording.PathName
import badlog.core.recording.Topic

/**
 * A text with a time.
 *
 * @property x where it stands on the x axis; NaN where the x axis has a gap.
 * @property row the row it was logged in, from 0; of a topic with times of its own, the sample.
 */
public class Event(public val x: Double, public val row: Int, public val text: String)

/**
 * What happened, in the order of the file.
 *
 * @property topic the topic it comes from.
 */
public class EventLog internal constructor(public val topic: Topic, xAxis: XAxis) {
    /** The full name, with its folder. */
    public val name: String get() = topic.name

    /** The heading above it: its name without the folder. */
    public val title: String get() = PathName.baseNameOf(topic.name)

    /** Each text cell of the topic; numbers and empty cells are not events. */
    public val events: List<Event> = object : AbstractList<Event>() {
        private val positions = positionsOf(topic, xAxis)

        override val size: Int get() = topic.texts.size

        override fun get(index: Int): Event {
            val row = topic.texts.rows[index]
            return Event(positions.getOrElse(row) { Double.NaN }, row, topic.texts[index])
        }
    }
}
