package badlog.report

import badlog.expression.Outcome
import badlog.expression.syntax.ExpressionErrorKind
import badlog.files.LogFile
import badlog.files.terminal.TextTable
import badlog.files.terminal.TextTable.Column
import badlog.rules.timeText

/**
 * Returns the logs in which the question holds, as a table at most [width] columns wide. Its columns: match, file, time and value. Below
 * it, the other logs are counted by reason, except for unreadable ones. If the question asks for a number, the table has all logs with that
 * number.
 */
fun findText(results: List<FindResult>, width: Int = TEXT_WIDTH): String {
    val found = results.filter(::isFound)
    val lines = ArrayList<String>()
    val names = shortNames(results.map { it.file })
    if (found.isNotEmpty()) {
        val rows = found.flatMap { result ->
            val reply = result.reply as Reply.Answered
            val file = names.getValue(result.file)
            val row = listOf(result.title ?: file, file, timeText(reply.time, reply.timeUnit), valueText(reply))
            if (reply.occurrences.isEmpty()) listOf(row) else reply.occurrences.map { row.take(2) + occurrenceTexts(it, reply.timeUnit) }
        }
        lines += TextTable(COLUMNS, width).lines(rows).flatten()
        lines += ""
    }
    lines += summaryOf(results, names, found.size)
    return lines.joinToString("\n")
}

/** The usual width of texts, in columns, unless a terminal requires another one. */
internal const val TEXT_WIDTH = 100

private val COLUMNS = listOf(Column("Match"), Column("File"), Column("Time", isWhole = true), Column("Value"))

/** Returns whether the question holds in the log of [result], or the log has the number that it asks for. */
internal fun isFound(result: FindResult): Boolean = when (val reply = result.reply) {
    is Reply.Answered -> when (reply.outcome) {
        Outcome.HOLDS -> true
        Outcome.NO_QUESTION -> reply.quantities.any { !it.value.isNaN() }
        else -> false
    }

    else -> false
}

private fun summaryOf(results: List<FindResult>, names: Map<LogFile, String>, found: Int): List<String> {
    val lines = ArrayList<String>()
    lines += "Found in $found of ${count(results.size, "log")}."
    val unknown = results.mapNotNull { it.reply as? Reply.Answered }.filter { it.outcome == Outcome.UNKNOWN || it.reason != null }
    unknown.groupBy { it.reason }.forEach { (reason, replies) ->
        lines += "Unknown in ${count(replies.size, "log")}" + if (reason == null) ", since samples are missing." else ": $reason"
    }
    lines += implausibleTexts(results.mapNotNull { it.reply as? Reply.Answered })
    val leftOut = results.count { it.reply is Reply.LeftOut }
    if (leftOut > 0) lines += "${count(leftOut, "log")} excluded by the question."
    val notAsked = results.mapNotNull { result -> (result.reply as? Reply.NotAsked)?.let { SkippedLog(names.getValue(result.file), it) } }
    val isAnswered = results.any { it.reply is Reply.Answered }
    val (missing, others) = notAsked.partition { it.reply.kind == ExpressionErrorKind.UNKNOWN_TOPIC }
    // If a name is missing, the rest of it may be read as anything. A question that is valid for one log is not a mistake for another.
    val (lacking, mistaken) = others.partition { isAnswered && it.reply.kind == ExpressionErrorKind.SYNTAX }
    missing.groupBy { it.reply.topic to it.reply.isOfHeader }.forEach { (what, replies) ->
        val (name, isOfHeader) = what
        lines += "${have(replies.size)} no ${if (isOfHeader) "header value" else "topic"} “$name”: ${listed(replies.map { it.file })}."
    }
    if (lacking.isNotEmpty()) {
        val lack = if (lacking.size == 1) "lacks" else "lack"
        lines += "${count(lacking.size, "log")} $lack some topics of the question: ${listed(lacking.map { it.file })}."
    }
    // If no log has the topic, it may be misspelled, and the message says more.
    if (!isAnswered) mostHelpful(missing.map { it.reply })?.let { lines += it.pointed }
    mistaken.map { it.reply }.groupBy { it.pointed }.forEach { (pointed, replies) ->
        lines +=
            "Skipped for ${count(replies.size, "log")}: $pointed"
    }
    lines += undefinedTexts(results.filter { it.reply !is Reply.Unreadable }.map { it.undefined })
    return lines
}

/** The [reply] that the question could not be evaluated for the log called [file]. */
private class SkippedLog(val file: String, val reply: Reply.NotAsked)

/** Returns sentences with the numbers of samples that were left out in [replies], since no robot has such values. */
private fun implausibleTexts(replies: List<Reply.Answered>): List<String> =
    replies.flatMap { it.implausible }.groupBy({ it.first }, { it.second }).map { (topic, counts) ->
        val samples = count(counts.sum(), "sample")
        "Left out $samples of “$topic” in ${count(counts.size, "log")}: no robot has such values."
    }

/** Returns the first of [files] as a list, and the number of the others. */
private fun listed(files: List<String>): String {
    val more = files.size - MAX_LISTED
    return if (more <= 0) files.joinToString() else "${files.take(MAX_LISTED).joinToString()} and $more more"
}

private const val MAX_LISTED = 3

private fun have(logs: Int) = "${count(logs, "log")} ${if (logs == 1) "has" else "have"}"

private fun occurrenceTexts(occurrence: Reply.Occurrence, unit: String): List<String> {
    val length = if (occurrence.span.width == 0.0) emptyList() else listOf("for ${timeText(occurrence.span.width, unit)}")
    return listOf(timeText(occurrence.span.from, unit), (length + occurrence.before.map { (name, text) -> "$name: $text" }).joinToString())
}

private fun valueText(reply: Reply.Answered): String {
    val times = if (reply.spanCount > 1) " (${reply.spanCount} times)" else ""
    val quantities = reply.quantities
    return (if (quantities.size == 1) quantities[0].text else quantities.joinToString { it.toString() }.ifEmpty { "yes" }) + times
}

internal fun count(number: Int, thing: String): String = "$number $thing${if (number == 1) "" else "s"}"
