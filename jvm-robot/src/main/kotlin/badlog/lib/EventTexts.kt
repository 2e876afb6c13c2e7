package badlog.lib

import java.util.concurrent.atomic.AtomicLong

/** Events that wait for a row. Safe for use by several threads. */
internal class EventTexts(private val dropped: AtomicLong) {
    private val waiting = StringBuilder()

    // Read without the lock in each row, so that rows without events cost nothing.
    @Volatile
    private var isWaiting = false

    fun add(text: String) {
        synchronized(this) {
            if (waiting.length + text.length > MOST_CHARACTERS) {
                dropped.incrementAndGet()
                return
            }
            if (waiting.isNotEmpty()) waiting.append(SEPARATOR)
            waiting.append(text)
            isWaiting = true
        }
    }

    /** All that waited, as the text of one cell, or null. A reader never takes it for a number. */
    fun take(): String? {
        if (!isWaiting) return null
        val text = synchronized(this) {
            isWaiting = false
            waiting.toString().also { waiting.setLength(0) }
        }
        return if (isReadAsEvent(text)) text else "event $text"
    }

    private fun isReadAsEvent(text: String): Boolean {
        val word = text.trim().lowercase()
        return word !in NO_EVENTS && word.toDoubleOrNull() == null
    }

    private companion object {
        const val SEPARATOR = "; "
        const val MOST_CHARACTERS = 10_000
        val NO_EVENTS = setOf("", "null", "true", "false", "nan", "inf", "+inf", "-inf", "infinity", "-infinity")
    }
}
