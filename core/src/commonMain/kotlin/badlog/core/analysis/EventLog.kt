package badlog.core.analysis

import badlog.core.recording.PathName
import badlog.core.recording.Topic

/**
 * A text with a time.
 *
 * @property x its position on the x axis; NaN if the x axis has a gap there.
 * @property row the index of its row, from 0; in a topic with times of its own, the index of its sample.
 */
public class Event(public val x: Double, public val row: Int, public val text: String)

/**
 * The events of one topic, in the order of the file.
 *
 * @property topic the topic that holds the events.
 */
public class EventLog internal constructor(public val topic: Topic, xAxis: XAxis) {
    /** The topic's full name, with its folder. */
    public val name: String get() = topic.name

    /** The heading above the events: the name without its folder. */
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
