package badlog.core.recording

/** Returns ` (3×)` to add to a sentence about something that happened [count] times; nothing for once. */
public fun timesText(count: Int): String = if (count == 1) "" else " ($count×)"
