package badlog.viewer.shown.table

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.signals.pose.lastAtOrBefore
import badlog.viewer.text.exactText
import badlog.viewer.text.unitText

/** A column of CSV with its [title], and its [cell] in each row. */
internal class CsvColumn(val title: String, val cell: (Int) -> String)

/** Returns the column of [topic] with its logged cells, row by row. */
internal fun loggedColumn(topic: Topic): CsvColumn {
    val isTruth = topic.kind == TopicKind.BOOLEAN
    // The index of the next text, because rows are requested one after another.
    var next = 0
    return CsvColumn(titleOf(topic.name, topic.unit)) { row ->
        val rows = topic.texts.rows
        if (next > 0 && next <= rows.size && rows[next - 1] >= row) next = 0
        while (next < topic.texts.size && rows[next] < row) next++
        val number = topic.samples.getOrElse(row) { Double.NaN }
        when {
            next < topic.texts.size && rows[next] == row -> cellOf(topic.texts[next])
            isTruth && !number.isNaN() -> "${number == 1.0}"
            else -> cellOf(number)
        }
    }
}

/** Returns the column of [line] with its last value at or before each of [times]. */
internal fun heldColumn(line: GraphSeries, times: DoubleArray): CsvColumn {
    val name = if (line.isDerived) "[${line.name}]" else line.topic.name
    return CsvColumn(titleOf(name, line.unit)) { row ->
        val data = line.data
        val index = if (data.x === times) row else data.lastAtOrBefore(times[row])
        val value = data.y.getOrElse(index) { Double.NaN }
        line.states?.takeIf { !value.isNaN() }?.let { states -> cellOf(states.getOrElse(value.toInt()) { "?" }) } ?: cellOf(value)
    }
}

/**
 * Returns the column of the events of [topic]. An event is in the row in which it was logged, or in the first of [times] that is not
 * before it.
 */
internal fun eventColumn(view: LogView, topic: Topic, times: DoubleArray): CsvColumn {
    val texts = HashMap<Int, String>()
    val clock = Series(times, times)
    for (event in view.eventsOf(topic).events) {
        val row = if (topic.times == null) event.row else clock.firstAtOrAfter(event.x)
        texts[row] = texts[row]?.let { "$it; ${event.text}" } ?: event.text
    }
    return CsvColumn(topic.name) { texts[it]?.let(::cellOf).orEmpty() }
}

private fun titleOf(name: String, unit: String) = unitText(unit).let { if (it.isEmpty()) name else "$name ($it)" }

/** Returns [number] as a cell, to its last digit; empty for NaN. */
internal fun cellOf(number: Double): String = when {
    number.isNaN() -> ""
    number.isInfinite() -> "$number"
    else -> exactText(number)
}

/** Returns [text] as a cell, quoted if necessary. */
internal fun cellOf(text: String): String = if (text.any { it in SPECIAL }) "\"${text.replace("\"", "\"\"")}\"" else text

private const val SPECIAL = ",\"\r\n"
