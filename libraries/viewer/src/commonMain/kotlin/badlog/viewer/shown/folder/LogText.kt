package badlog.viewer.shown.folder

import badlog.core.recording.Severity
import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.secondsOf
import badlog.viewer.text.NO_NUMBER
import badlog.viewer.text.countText
import badlog.viewer.text.fixedText
import badlog.viewer.text.minutesText
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit
import badlog.viewer.text.word
import kotlin.math.floor

/** Whether the battery came near the voltage at which a roboRIO disables outputs. */
val ListedLog.isNearBrownout: Boolean get() = (summary.batteryMinimum ?: Double.MAX_VALUE) < BROWNOUT_NEAR

/** A voltage near a brownout, in V. */
private const val BROWNOUT_NEAR = 7.0

/** Returns the duration as `2:47`; null if unknown. */
fun durationText(log: ListedLog): String? {
    val duration = log.summary.duration ?: return null
    val seconds = secondsOf(duration, log.summary.xUnit) ?: return withUnit(numberText(duration), log.summary.xUnit)
    if (!(seconds < 1e9)) return null
    if (seconds < 10) return "${fixedText(seconds, 1)} s"
    return minutesText(seconds, decimals = 0)
}

/**
 * Returns the lowest battery voltage as `6.73 V`; null if no topic shows it. It is rounded down, so that it does not look better than it
 * was.
 */
fun batteryText(log: ListedLog): String? = log.summary.batteryMinimum?.let { "${fixedText(floor(it * 100 + 1e-6) / 100, 2)} V" }

/** Returns the number of errors and warnings as `2 problems`; null if there are none. */
fun problemText(log: ListedLog): String? = when {
    !log.isReadable -> "unreadable"
    else -> (log.summary.problems.errors + log.summary.problems.warnings).takeIf { it > 0 }?.let { countText(it, "problem") }
}

/** The severity of the worst error or warning among its problems; null if there are none. */
val ListedLog.problemSeverity: Severity?
    get() = when {
        !isReadable || summary.problems.errors > 0 -> Severity.ERROR
        summary.problems.warnings > 0 -> Severity.WARNING
        else -> null
    }

/** Returns the heading of a shown log, [title], beside a list of logs. The list may be of another folder, or no longer have the log. */
fun headingOf(title: String, isListed: Boolean): String = if (isListed) title else "$title · not in the list"

/** Returns the problems in words, for a tooltip. */
fun problemSentence(log: ListedLog): String = log.summary.trouble ?: with(log.summary.problems) {
    listOfNotNull(
        counted(errors, "error"),
        counted(warnings, "warning"),
        counted(notes, "hint"),
    ).joinToString(", ")
}

private fun counted(count: Int, what: String) = if (count == 0) null else countText(count, what)

/**
 * Returns what happened, as a sentence without a full stop, and the number of other rules that found something: `Browned out at 1:33 +3`.
 * It is null if nothing was found or the log is idle, `…` until the rules have run, and `–` if they cannot run. The rules do not run by
 * themselves over a log that is elsewhere.
 */
fun foundText(log: ListedLog): String? {
    if (log.isGray) return null
    val found = log.found ?: return "…".takeIf { log.isHere }
    val rules = found.rules ?: return NO_NUMBER
    val first = found.verdict?.headline ?: rules.firstOrNull()?.name ?: return null
    return if (rules.size > 1) "$first +${rules.size - 1}" else first
}

/** Returns all findings of the rules, one per line; may be empty. */
fun foundLines(log: ListedLog): String = log.found?.rules.orEmpty().joinToString("\n") { "${it.severity.word}: ${it.name}" }
