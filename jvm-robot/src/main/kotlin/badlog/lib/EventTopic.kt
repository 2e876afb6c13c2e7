package badlog.lib

import badlog.core.bag.BagTopic
import badlog.core.bag.RowWriter
import java.util.concurrent.atomic.AtomicLong

/** A topic of events: each row has all events since the previous row, however often the topics were updated. */
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

/** A column in which the log itself can note faults. */
internal interface EventSink {
    /** The texts that wait for the next row that has room. */
    val texts: EventTexts
}

/** Events that wait for a row, and events in rows that are not written yet. If writing fails, the latter wait again. Thread-safe.  */
internal class EventTexts(private val dropped: AtomicLong) {
    private val waiting = StringBuilder()
    private val taken = StringBuilder()
    private var eventsWaiting = 0L
    private var eventsTaken = 0L

    // Each row reads this without the lock, so that rows without events cost nothing.
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

    /** Takes all waiting events and returns them as the text of one cell, or null if there are none. The text never looks like a number. */
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

    /** Marks the rows that took events as written. */
    fun written() {
        if (isTaken) synchronized(this) { forgetTaken() }
    }

    /** Marks the rows that took events as lost: their events wait again. */
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

    /** Counts the waiting events as dropped, because no row will contain them. */
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
