package badlog.lib

/** An event log, created by [BadLog.createEvents]. Safe for use by several threads. */
public class Events internal constructor(private val topic: EventTopic, private val faults: Faults) {
    /**
     * Logs that something happened. It stands in the next row; several events of one row stand in it together, in
     * order, with `; ` between them. Never throws; null and texts without anything in them are ignored.
     */
    public fun event(text: String?) {
        if (text.isNullOrBlank()) {
            faults.callIgnored(topic.name) { "The event log \"${topic.name}\" was given an event without a text." }
        } else {
            topic.texts.add(text)
        }
    }
}
