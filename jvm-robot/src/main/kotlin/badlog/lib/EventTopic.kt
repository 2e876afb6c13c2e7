package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter
import java.util.concurrent.atomic.AtomicLong

/** A topic of events: each row takes all that happened since the row before, however often the topics were updated. */
internal class EventTopic(name: String, override val texts: EventTexts) :
    Topic(BagTopic(name, attributes = listOf("log"))),
    EventSink {

    override fun sample() = Unit

    override fun commit() = Unit

    override fun write(row: RowWriter) {
        val text = texts.take()
        if (text == null) row.empty() else row.text(text)
    }
}

/** A column into which the log itself can write what went wrong. */
internal interface EventSink {
    /** What waits for the next row that has room. */
    val texts: EventTexts
}

/**
 * Events that wait for a row, and those a row took that is not written yet: they come back if it cannot be. Safe for
 * use by several threads.
 */
internal class EventTexts(private val dropped: AtomicLong) {
    private val waiting = StringBuilder()
    private val taken = StringBuilder()
    private var eventsWaiting = 0L
    private var eventsTaken = 0L

    // Read without the lock in each row, so that rows without events cost nothing.
    @Volatile
    private var isWaiting = false

    @Volatile
    private var isTaken = false

    fun add(text: String) {
        synchronized(this) {
            if (waiting.length + taken.length + text.length > MAX_CHARACTERS) {
                dropped.incrementAndGet()
                return
            }
            waiting.appendEvent(text)
            eventsWaiting++
            isWaiting = true
        }
    }

    /** All that waited, as the text of one cell, or null. A reader never takes it for a number. */
    fun take(): String? {
        if (!isWaiting) return null
        val text = synchronized(this) {
            isWaiting = false
            waiting.toString().also {
                taken.appendEvent(it)
                waiting.setLength(0)
                eventsTaken += eventsWaiting
                eventsWaiting = 0
                isTaken = true
            }
        }
        return if (isReadAsEvent(text)) text else "event $text"
    }

    /** Says that the rows which took events are written. */
    fun written() {
        if (isTaken) synchronized(this) { forgetTaken() }
    }

    /** Says that the rows which took events are lost: the events wait again. */
    fun restore() {
        if (!isTaken) return
        synchronized(this) {
            if (waiting.isNotEmpty()) taken.append(SEPARATOR)
            waiting.insert(0, taken)
            eventsWaiting += eventsTaken
            isWaiting = true
            forgetTaken()
        }
    }

    /** Counts what still waits: no row will take it. */
    fun end() {
        synchronized(this) {
            dropped.addAndGet(eventsWaiting)
            waiting.setLength(0)
            eventsWaiting = 0
            isWaiting = false
        }
    }

    private fun forgetTaken() {
        taken.setLength(0)
        eventsTaken = 0
        isTaken = false
    }

    private fun StringBuilder.appendEvent(text: String) {
        if (isNotEmpty()) append(SEPARATOR)
        append(text)
    }

    private fun isReadAsEvent(text: String): Boolean {
        val word = text.trim().lowercase()
        return word !in NO_EVENTS && word.toDoubleOrNull() == null
    }

    private companion object {
        const val SEPARATOR = "; "
        const val MAX_CHARACTERS = 10_000
        val NO_EVENTS = setOf("", "null", "true", "false", "nan", "inf", "+inf", "-inf", "infinity", "-infinity")
    }
}
