package badlog.page.opened

import badlog.core.recording.Severity
import badlog.page.dom.json
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FoundRule
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogFound
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.ProblemCounts

/** What a worker learned of a log, as a message: what lists show, in plain arrays. */
internal object SummaryMessage {
    /** Returns [summary] and [found], null while the rules run, as a message. */
    fun of(summary: LogSummary, found: LogFound?): dynamic = json(
        "match" to with(summary.match) { arrayOf(event, type, number, alliance) },
        "second" to summary.date.second.toDouble(),
        "source" to summary.date.source.ordinal,
        "duration" to summary.duration,
        "unit" to summary.xUnit,
        "samples" to summary.samples.toDouble(),
        "problems" to with(summary.problems) { arrayOf(errors, warnings, notes) },
        "content" to summary.content.ordinal,
        "trouble" to summary.trouble,
        "battery" to summary.batteryMinimum,
        "hasRun" to (found != null),
        "found" to found?.rules?.map { arrayOf(it.name, it.severity.ordinal) }?.toTypedArray(),
    )

    /** Returns [log] with what [message] says of it. */
    fun read(message: dynamic, log: OpenedLog): OpenedLog {
        val match = message.match.unsafeCast<Array<String?>>()
        val problems = message.problems.unsafeCast<Array<Int>>()
        val rules = message.found.unsafeCast<Array<Array<dynamic>>?>()
            ?.map { FoundRule(it[0] as String, Severity.entries[it[1] as Int]) }
        val summary = LogSummary(
            match = MatchOfLog(match[0], match[1], match[2], match[3]),
            date = LogDate((message.second as Double).toLong(), DateSource.entries[message.source as Int]),
            duration = message.duration as Double?,
            xUnit = message.unit as String,
            samples = (message.samples as Double).toLong(),
            problems = ProblemCounts(problems[0], problems[1], problems[2]),
            content = Content.entries[message.content as Int],
            trouble = message.trouble as String?,
            batteryMinimum = message.battery as Double?,
        )
        return log.with(summary, if (message.hasRun as Boolean) LogFound(0, rules) else null)
    }
}
