package badlog.signals.clock

import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.recording.Recording
import badlog.core.text.daysTo
import badlog.signals.match.MatchOfLog
import badlog.signals.match.matchOf
import badlog.signals.match.writtenDate
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals

/**
 * A log, with everything that shows which other log is from the same time. All properties are evaluated lazily.
 *
 * @property name the name of its file.
 * @property recording its content.
 * @param vocabulary the names of its topics.
 */
class ClockedLog(val name: String, val recording: Recording, internal val vocabulary: SignalVocabulary) {
    internal val view: LogView = LogView.of(recording)

    /** Whether its x is a time, or a number without a unit that a person has made the x axis. */
    val hasClock: Boolean =
        view.xAxis.run { !isIndex && (Units.secondsIn(unit) != null || Units.isNone(unit)) && range != null }

    /** Its first x, in s; NaN if it has none. */
    val first: Double = (view.xAxis.range?.start ?: Double.NaN) * view.secondsPerX

    /** Its last x, in s; NaN if it has none. */
    val last: Double = (view.xAxis.range?.endInclusive ?: Double.NaN) * view.secondsPerX

    /** The time of day at which its x is 0, in s since 1970, from its values or its name. Null if neither has it. */
    val start: Double? by lazy {
        // The logged start is the time of the first sample.
        loggedStart(recording)?.let { it - if (first.isNaN()) 0.0 else first } ?: timeInName(name)
    }

    /** The moments at which the robot was enabled and disabled. */
    val edges: List<EnabledEdge> by lazy { view.withSignals(vocabulary, name).enabledEdges() }

    /** The match in which it was recorded. */
    val match: MatchOfLog by lazy { vocabulary.matchOf(recording, name) }
}

/** Returns the time in [name], the name of a file, in s since 1970; null if there is none. */
internal fun timeInName(name: String): Double? = NAMED.find(name)?.let { secondsOf(it.groupValues) }

/** The forms in which WPILib and CTRE name their logs, in UTC. */
private val NAMED = Regex("(?<!\\d)(\\d{4})-?(\\d{2})-?(\\d{2})_(\\d{2})-?(\\d{2})-?(\\d{2})(?!\\d)")

/** The name of the value that says when a log began. */
const val START_VALUE: String = "Start Time"

/** Returns when the log [recording] began, in s since 1970. Null unless the log states this in UTC or with an offset. */
fun loggedStart(recording: Recording): Double? {
    val text = recording.values.find { it.name == START_VALUE }?.text ?: return null
    return LOGGED.matchEntire(text)?.let { secondsOf(it.groupValues) } ?: writtenDate(text)?.utcSecond?.toDouble()?.takeIf { it >= FIRST }
}

private val LOGGED = Regex("(\\d{4})-(\\d{2})-(\\d{2})[ T](\\d{2}):(\\d{2}):(\\d{2}(?:\\.\\d+)?)(?: UTC|Z)")

/**
 * Returns the seconds since 1970 for the date and time in [parts]. From index 1 on, they are year, month, day, hour, minute and second;
 * null for an invalid time.
 */
private fun secondsOf(parts: List<String>): Double? {
    val (year, month, day, hour, minute) = parts.subList(1, 6).map { it.toInt() }
    val second = parts[6].toDouble()
    if (hour > 23 || minute > 59 || second >= 60 || year !in YEARS) return null
    val days = daysTo(year, month, day) ?: return null
    return days * DAY + hour * 3600 + minute * 60 + second
}

/** A robot's clock starts at about 1970 until something sets it. */
private val YEARS = 2000..2199
private const val DAY = 86400.0

/** The beginning of 2000. */
private const val FIRST = 946_684_800.0
