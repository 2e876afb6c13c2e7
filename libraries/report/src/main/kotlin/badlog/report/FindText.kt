package badlog.report

import badlog.expression.Outcome
import badlog.expression.syntax.ExpressionErrorKind
import badlog.rules.timeText
import badlog.terminal.TextTable

/**
 * Returns the logs in which the question holds, as a table of match, file, time and value at most 100 columns wide, and below it
 * how many others there were and why, except for those that cannot be read. For a question that asks for a number, all logs that
 * have it.
 */
fun findText(results: List<FindResult>): String {
    val found = results.filter(::isFound)
    val lines = ArrayList<String>()
    if (found.isNotEmpty()) {
        val names = shortNames(results.map { it.file })
        val rows = found.flatMap { result ->
            val reply = result.reply as Reply.Answered
            val file = names.getValue(result.file)
            val row = listOf(result.title ?: file, file, timeText(reply.time, reply.timeUnit), valueText(reply))
            if (reply.occurrences.isEmpty()) listOf(row) else reply.occurrences.map { row.take(2) + occurrenceTexts(it, reply.timeUnit) }
        }
        lines += TABLE.lines(rows).flatten()
        lines += ""
    }
    lines += summaryOf(results, found.size)
    return lines.joinToString("\n")
}

/** The maximum width of texts for a terminal. */
internal const val TEXT_WIDTH = 100

private val TABLE = TextTable(listOf("Match", "File", "Time", "Value").map { TextTable.Column(it) }, TEXT_WIDTH)

/** Returns whether the question holds there, or there is the number it asks for. */
internal fun isFound(result: FindResult): Boolean = when (val reply = result.reply) {
    is Reply.Answered -> when (reply.outcome) {
        Outcome.HOLDS -> true
        Outcome.NO_QUESTION -> reply.quantities.any { !it.value.isNaN() }
        else -> false
    }

    else -> false
}

private fun summaryOf(results: List<FindResult>, found: Int): List<String> {
    val lines = ArrayList<String>()
    lines += "Found in $found of ${count(results.size, "log")}."
    val unknown = results.mapNotNull { it.reply as? Reply.Answered }.filter { it.outcome == Outcome.UNKNOWN || it.reason != null }
    unknown.groupBy { it.reason }.forEach { (reason, replies) ->
        lines += "Unknown in ${count(replies.size, "log")}" + if (reason == null) ", since samples are missing." else ": $reason"
    }
    val leftOut = results.count { it.reply is Reply.LeftOut }
    if (leftOut > 0) lines += "${count(leftOut, "log")} excluded by the question."
    val notAsked = results.mapNotNull { it.reply as? Reply.NotAsked }
    val isAnswered = results.any { it.reply is Reply.Answered }
    val (missing, others) = notAsked.partition { it.kind == ExpressionErrorKind.UNKNOWN_TOPIC }
    // If a name is missing, the rest of it may be read as anything; but a question that is valid for one log is not a mistake for another.
    val (lacking, mistaken) = others.partition { isAnswered && it.kind == ExpressionErrorKind.SYNTAX }
    missing.groupBy { it.topic to it.isOfHeader }.forEach { (what, replies) ->
        val (name, isOfHeader) = what
        lines += "${have(replies.size)} no ${if (isOfHeader) "header value" else "topic"} “$name”."
    }
    if (lacking.isNotEmpty()) {
        lines += "${count(lacking.size, "log")} ${if (lacking.size == 1) "lacks" else "lack"} some topics of the question."
    }
    // If no log has the topic, it may be misspelled, and the message says more.
    if (missing.isNotEmpty() && !isAnswered) lines += missing.maxBy { it.place }.pointed
    mistaken.groupBy { it.pointed }.forEach { (pointed, replies) -> lines += "Skipped for ${count(replies.size, "log")}: $pointed" }
    lines += undefinedTexts(results.filter { it.reply !is Reply.Unreadable }.map { it.undefined })
    return lines
}

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
