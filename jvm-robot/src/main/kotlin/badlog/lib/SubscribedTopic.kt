package badlog.lib

import badlog.core.bag.BagTopic
import badlog.core.bag.RowWriter
import java.util.function.Function

/**
 * A topic with values that the robot's code publishes, from any thread, at any time. It has its own lock, held for a few nanoseconds, so
 * publishers never wait for a write. An event log has room for the log's own events in rows without a new text.
 */
internal class SubscribedTopic(
    description: BagTopic,
    private val mode: DataInferMode,
    private val numberText: NumberText,
    override val texts: EventTexts,
) : Topic(description),
    EventSink {
    /** Whether it can hold the log's own events. */
    val isEventLog: Boolean = "log" in description.attributes

    private var isPublished = false
    private var publishedNumber = 0.0
    private var publishedText: String? = null
    private var publishedFunction: Function<in Double, out String?>? = null

    private var number = 0.0
    private var text: String? = BadLog.DEFAULT_DATA
    private var function: Function<in Double, out String?>? = null
    private var isNew = false

    fun publish(value: Double) {
        synchronized(this) {
            publishedNumber = value
            publishedText = null
            publishedFunction = numberText.function
            isPublished = true
        }
    }

    fun publish(value: String) {
        synchronized(this) {
            publishedText = value
            isPublished = true
        }
    }

    override fun sample() = Unit

    override fun commit() {
        synchronized(this) {
            isNew = isPublished
            if (isPublished) {
                number = publishedNumber
                text = publishedText
                function = publishedFunction
                isPublished = false
            } else if (mode == DataInferMode.DEFAULT) {
                text = BadLog.DEFAULT_DATA
            }
        }
    }

    override fun write(row: RowWriter) {
        val text = (if (isNew) null else texts.take()) ?: text
        if (text != null) row.text(text) else numberText.write(number, function, this, row)
    }
}
