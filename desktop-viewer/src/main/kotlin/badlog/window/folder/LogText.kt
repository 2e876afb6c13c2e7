package badlog.window.folder

import badlog.catalog.LogDate
import badlog.catalog.folder.LogEntry
import badlog.catalog.secondsOf
import badlog.viewer.text.NO_NUMBER
import badlog.viewer.text.minutesText
import java.time.LocalDateTime
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.util.Locale

/** The window's language. */
internal val ENGLISH: Locale = Locale.ENGLISH

/** Below this many volts a roboRIO begins to cut outputs. */
internal const val BROWNOUT_NEAR = 7.0

private val DATE = DateTimeFormatter.ofPattern("d MMM yyyy, HH:mm", ENGLISH)

/** Returns `16 Mar 2024, 10:41`. */
internal fun dateText(date: LogDate): String = DATE.format(date.time)

/** Returns `2:47`; null when it is not known. */
internal fun durationText(entry: LogEntry): String? {
    val duration = entry.summary.duration ?: return null
    val seconds = secondsOf(duration, entry.summary.xUnit) ?: return "%.4g %s".format(ENGLISH, duration, entry.summary.xUnit)
    if (!(seconds < 1e9)) return null
    if (seconds < 10) return "%.1f s".format(ENGLISH, seconds)
    return minutesText(seconds, decimals = 0)
}

/** Returns `1.8 MB`. */
internal fun sizeText(bytes: Long): String = when {
    bytes < 1000 -> "$bytes B"
    bytes < 999_500 -> "%.0f kB".format(ENGLISH, bytes / 1e3)
    bytes < 999_950_000 -> "%.1f MB".format(ENGLISH, bytes / 1e6)
    else -> "%.1f GB".format(ENGLISH, bytes / 1e9)
}

/** Returns `6.73 V`; null if no topic shows it. Rounded down, so that it does not look better than it was. */
internal fun batteryText(entry: LogEntry): String? =
    entry.summary.batteryMinimum?.let { "%.2f V".format(ENGLISH, kotlin.math.floor(it * 100 + 1e-6) / 100) }

/** Returns the number of problems that matter; null if there are none. */
internal fun problemText(entry: LogEntry): String? = when {
    !entry.isReadable -> "unreadable"
    else -> (entry.summary.problems.errors + entry.summary.problems.warnings).takeIf { it > 0 }?.toString()
}

/** Returns the problems in words, for a tip. */
internal fun problemSentence(entry: LogEntry): String = entry.summary.trouble ?: with(entry.summary.problems) {
    listOfNotNull(
        counted(errors, "error", "errors"),
        counted(warnings, "warning", "warnings"),
        counted(notes, "note", "notes"),
    ).joinToString(", ")
}

private fun counted(count: Int, one: String, many: String) = if (count == 0) null else "$count ${if (count == 1) one else many}"

/**
 * Returns `Browned out +3`: the worst finding, and the number of others; null for nothing, `…` until rules have run, `–` if they cannot
 * run.
 */
internal fun foundText(entry: LogEntry): String? {
    if (entry.isGray) return null
    val found = entry.found ?: return "…"
    val rules = found.rules ?: return NO_NUMBER
    val first = rules.firstOrNull() ?: return null
    return if (rules.size > 1) "${first.name} +${rules.size - 1}" else first.name
}

/** Returns everything that the rules found, one per line; empty for nothing. */
internal fun foundLines(entry: LogEntry): String =
    entry.found?.rules.orEmpty().joinToString("\n") { "${it.severity.name.lowercase()}: ${it.name}" }

/** The time on a clock on the wall. */
internal val LogDate.time: LocalDateTime get() = LocalDateTime.ofEpochSecond(second, 0, ZoneOffset.UTC)
