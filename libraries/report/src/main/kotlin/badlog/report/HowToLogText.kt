package badlog.report

import badlog.signals.logging.LoggingLibrary
import badlog.signals.logging.howToLog

/**
 * Returns the lines of a robot program that log the missing [signals] with WPILib alone, at most [MAX_LINES]. Null if no line is known for
 * any of them. The report's JSON has the lines of other libraries.
 */
internal fun howToLogText(signals: List<String>): String? {
    val lines = signals.mapNotNull { howToLog(it, LoggingLibrary.WPILIB) }.distinct().take(MAX_LINES)
    if (lines.isEmpty()) return null
    val others = (LoggingLibrary.entries - LoggingLibrary.WPILIB).joinToString { it.title }
    val place = LoggingLibrary.WPILIB.place.trimEnd('.').replaceFirstChar { it.lowercase() }
    return "A robot program logs the missing signals with these lines, $place (--json has them for $others):\n" +
        lines.joinToString("\n") { "  $it" }
}

/**
 * Returns, for each of [signals], the line that logs it with each library, by the library's title. Signals without such a line are omitted.
 */
internal fun howToLogAll(signals: List<String>): Map<String, Map<String, String>> = signals.associateWith { signal ->
    LoggingLibrary.entries.mapNotNull { library -> howToLog(signal, library)?.let { library.title to it } }.toMap()
}.filterValues { it.isNotEmpty() }

private const val MAX_LINES = 5
