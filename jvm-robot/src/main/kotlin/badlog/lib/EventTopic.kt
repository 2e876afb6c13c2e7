package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter

/** A topic of events: each row takes all that happened since the row before, however often the topics were updated. */
internal class EventTopic(name: String, override val texts: EventTexts) :
    Topic(BagTopic(name, attributes = listOf("log"))),
    EventRoom {

    override fun sample() = Unit

    override fun commit() = Unit

    override fun write(row: RowWriter) {
        val text = texts.take()
        if (text == null) row.empty() else row.text(text)
    }
}
