package badlog.core.recording

/** Returns a suffix for a sentence about an event that occurred [count] times, such as ` (3×)`; empty for 1. */
public fun timesText(count: Int): String = if (count == 1) "" else " ($count×)"
