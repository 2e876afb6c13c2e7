package badlog.report.page

import badlog.report.LogReport
import badlog.signals.match.MatchType
import badlog.signals.match.NaturalOrder
import java.time.LocalDateTime
import java.time.ZoneOffset

/** The logs of one event and one type of match, in the order of the matches. */
internal class MatchGroup(val title: String, val logs: List<IndexedLog>)

/** Returns [logs] by event, in the order of time; within an event, practice is first, then qualification, then playoffs. */
internal fun groupsOf(logs: List<IndexedLog>): List<MatchGroup> {
    val events = logs.groupBy { it.report.match.event?.trim()?.lowercase() }.values.flatMap(::byYear)
    return events.sortedWith(BY_TIME).flatMap { event ->
        event.logs.groupBy(::typeOf).entries.sortedWith(compareBy({ it.key == null }, { it.key })).map { (type, some) ->
            MatchGroup("${event.title} · ${type?.title ?: OTHER}", some.sortedWith(BY_NUMBER))
        }
    }
}

private class Event(val title: String, val isKnown: Boolean, val logs: List<IndexedLog>) {
    val began: Long = logs.minOf { it.report.began ?: Long.MAX_VALUE }
}

/** An event has the same name each year. A log without a year is of the only one there is. */
private fun byYear(logs: List<IndexedLog>): List<Event> {
    val name = logs.first().report.match.event?.trim()
    if (name == null) return listOf(Event(NO_EVENT, isKnown = false, logs))
    val only = logs.mapNotNull { yearOf(it.report) }.distinct().singleOrNull()
    return logs.groupBy { yearOf(it.report) ?: only }.map { (year, some) ->
        Event(if (year == null || "$year" in name) name else "$name $year", isKnown = true, some)
    }
}

/** Returns the year in which the log of [report] began; null if that is unknown. */
internal fun yearOf(report: LogReport): Int? = report.began?.let { LocalDateTime.ofEpochSecond(it, 0, ZoneOffset.UTC).year }

private fun typeOf(log: IndexedLog): MatchType? = log.report.matchType?.let(MatchType::of)

private val BY_TIME = compareBy<Event> { !it.isKnown }.thenBy { it.began }.thenBy(NaturalOrder) { it.title }

private val BY_NUMBER = compareBy<IndexedLog> { it.report.match.number == null }.thenBy(NaturalOrder) { it.report.match.number.orEmpty() }
    .thenBy { it.report.began ?: Long.MAX_VALUE }.thenBy { it.number }

private const val NO_EVENT = "No event"
private const val OTHER = "Other"
