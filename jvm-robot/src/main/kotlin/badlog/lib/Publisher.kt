package badlog.lib

/**
 * Publishes to one subscriber topic without looking up its name. Created by [BadLog.createPublisher]. Thread-safe;
 * never throws, and never waits for a file.
 */
public class Publisher internal constructor(private val topic: SubscribedTopic, private val faults: Faults) {
    /** Publishes [value] for the next [BadLog.updateTopics]; only the last value published before it counts. */
    public fun publish(value: Double) {
        topic.publish(value)
    }

    /** Publishes [value] for the next [BadLog.updateTopics]; only the last value published before it counts. Null is ignored. */
    public fun publish(value: String?) {
        if (value == null) faults.publishIgnored(topic.name) { nullPublished(topic.name) } else topic.publish(value)
    }
}

internal fun nullPublished(name: String): String = "null was published to the topic \"$name\"; it is ignored."
