package badlog.lib

/** An event log, created by [BadLog.createEvents]. Thread-safe. */
public class Events internal constructor(private val topic: EventTopic, private val faults: Faults) {
    /**
     * Logs that something happened. The event goes into the next row; several events in one row are joined in order with `; `. Never
     * throws; null and blank texts are ignored.
     */
    public fun event(text: String?) {
        if (text.isNullOrBlank()) {
            faults.callIgnored(topic.name) { "The event log \"${topic.name}\" was given an event without a text." }
        } else {
            topic.texts.add(text)
        }
    }
}
