package badlog.viewer.panel

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.core.analysis.XAxis
import badlog.core.analysis.statistics
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.draw.plot.HISTOGRAM_HEIGHT
import badlog.viewer.draw.plot.drawHistogram
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.statistics.ChannelOrder
import badlog.viewer.shown.statistics.Channels
import badlog.viewer.shown.statistics.Histogram
import badlog.viewer.shown.statistics.NamedDifference
import badlog.viewer.shown.statistics.StateTime
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.shown.statistics.timesOf
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.viewer.state.StatisticsRange
import badlog.viewer.state.StatisticsState
import badlog.viewer.text.countText
import badlog.viewer.text.exactText
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit

/**
 * A line with statistics.
 *
 * @property name its name among the others.
 * @property color the index of its color; null if all lines of the log have the same.
 * @property log the name of its log; empty if only one is drawn.
 * @property offset the number added to its x to align it with the open log.
 */
class MeasuredLine(val line: GraphSeries, val name: String, val color: Int?, val log: String = "", val offset: Double = 0.0) {
    /** Its states over x. */
    val runs: StateRuns by lazy { line.stateRuns() }
}

/**
 * The lines with statistics.
 *
 * @property tables the lines of each table.
 * @property graphs lines that are drawn together, for their differences.
 * @property channels the channels to rank; null for none.
 */
class Measured(val tables: List<List<MeasuredLine>>, val graphs: List<List<MeasuredLine>>, val channels: Channels?)

/**
 * Returns the statistics of [lines] over [part]. The calculation takes a while.
 *
 * @param axis the x axis of the open log.
 * @param unfolded whether a person has opened the histograms, by their keys.
 */
fun statisticsOf(lines: Measured, part: NamedSpan, axis: XAxis, state: StatisticsState, unfolded: Map<String, Boolean>): List<Part> {
    val all = StatisticsTables(part.parts, axis, state, unfolded)
    val how = if (lines.tables.flatten().all { it.line.states != null }) "" else ". ${Statistic.BY_TIME}"
    val tables = lines.tables.flatMapIndexed(all::of) + lines.graphs.flatMapIndexed(all::differences)
    return listOf(Paragraph("span", part.text(axis) + how, Tone.MUTED)) + tables + lines.channels?.let(all::ranked).orEmpty()
}

/** Returns the choice of the range of statistics at [place]. */
fun rangeChoice(place: Place, enabled: List<EnabledSpan>, state: StatisticsState): Choice {
    val shown = when {
        place.selection != null -> "Selected"
        place.cursors.between != null -> "A–B"
        else -> "Visible"
    }
    val ranges = StatisticsRange.entries.filter { it != StatisticsRange.ENABLED || enabled.isNotEmpty() }
    val chosen = state.range.takeIf { it in ranges } ?: StatisticsRange.SHOWN
    val options = ranges.map { range ->
        val label = when (range) {
            StatisticsRange.SHOWN -> shown
            StatisticsRange.ENABLED -> "Enabled"
            StatisticsRange.ALL -> "All"
        }
        Button(label, Action.Measure(state.copy(range = range)), isOn = range == chosen)
    }
    return Choice("range", "Statistics of", options)
}

/** Returns the [tables] as lines of tab-separated cells, for spreadsheets; the first line has the titles of the columns. */
fun tsvOf(tables: List<Table>, part: NamedSpan): String {
    val columns = tables.flatMap { table -> table.columns.drop(1).map { it.title } }.distinct()
    val head = listOf("topic", "unit", "log", "from", "to") + columns
    val lines = tables.flatMap { table ->
        table.rows.map { row ->
            val cells = table.columns.drop(1).map { it.title }.zip(row.cells.drop(1).map { it.single().hint }).toMap()
            val ends = listOf(part.span.from, part.span.to).map(::exactText)
            listOf(row.name, row.unit, row.log) + ends + columns.map { cells[it].orEmpty() }
        }
    }
    return (listOf(head) + lines).joinToString("\n", postfix = "\n") { line ->
        line.joinToString("\t") { cell -> cell.replace(Regex("[\t\n\r]"), " ") }
    }
}

private class StatisticsTables(
    private val parts: List<Span>,
    private val axis: XAxis,
    private val state: StatisticsState,
    private val unfolded: Map<String, Boolean>,
) {
    /** Returns a table of [lines] with numbers, its open histograms, and a table of those with states. */
    fun of(index: Int, lines: List<MeasuredLine>): List<Part> {
        val (lanes, numbers) = lines.partition { it.line.states != null }
        val below = ArrayList<Part>()
        val rows = numbers.map { line ->
            val found = line.line.statistics(partsOf(line))
            // The name of the topic, since lines of two folders may have the same name.
            val key = "histogram ${line.line.topic.name} ${line.line.name}"
            val isOpen = unfolded[key] == true
            val open =
                Button("Histogram of ${line.name}: ${Histogram.HINT}", Action.Unfold(key, !isOpen), PartIcon.HISTOGRAM, isOn = isOpen)
            if (isOpen) below += histogram("$key ${line.log}", line, found)
            row(line, Statistic.entries.map { cell(it, found, line) }, if (found.mean.isNaN()) emptyList() else listOf(open))
        }
        val columns = listOf(Column("Line")) + Statistic.entries.map { Column(it.title, it.hint) }
        return table("lines $index", columns, rows) + below + table("lanes $index", LANES, lanes.flatMap(::states))
    }

    private fun cell(statistic: Statistic, found: SeriesStatistics, line: MeasuredLine): Cell {
        val value = statistic.of(found)
        return Cell(statistic.textOf(value), exactText(value), statistic.unitOf(line.line.unit, axis.unit))
    }

    private fun histogram(key: String, line: MeasuredLine, found: SeriesStatistics): Part {
        val histogram = Histogram.of(line.line, partsOf(line), found) ?: return Paragraph("unit $key", Histogram.NONE, Tone.MUTED)
        return Picture(key, "Histogram of ${line.name}", HISTOGRAM_HEIGHT) { pen, width, colors ->
            pen.drawHistogram(histogram, line.line.unit, line.color ?: 0, width, colors)
        }
    }

    private fun states(line: MeasuredLine) =
        line.runs.timesOf(line.line.states.orEmpty(), partsOf(line)).take(StateTime.MAX_LISTED).mapIndexed { i, time ->
            row(line, listOf(time.state, time.timeText(axis), time.shareText, countText(time.count)).map { Cell(it) }, continues = i > 0)
        }

    /** Returns how the [lines] of graph [index] after the first differ from it; empty if they cannot be compared. */
    fun differences(index: Int, lines: List<MeasuredLine>): List<Part> {
        val offset = lines.firstOrNull()?.offset ?: return emptyList()
        val rows = NamedDifference.of(lines.map { it.line }, partsOf(lines[0])).map { difference ->
            val (one, other) = listOf(difference.one, difference.other).map { line -> lines.first { it.line === line } }
            val cells = difference.texts(axis, offset).zip(difference.exactTexts(offset)) { text, exact -> Cell(text, exact) }
            rowOf("${one.name} − ${other.name}", cells, one.line.unit, one.log, one.color.takeIf { one.log.isNotEmpty() })
        }
        val columns = listOf(Column("Difference")) + NamedDifference.TITLES.zip(NamedDifference.HINTS, ::Column)
        return table("differences $index", columns, rows)
    }

    /** Returns a ranking of the [channels]; empty if none had a current. */
    fun ranked(channels: Channels): List<Part> {
        val columns = ChannelOrder.entries.map { order ->
            Column(order.title, order.hint, Action.Measure(state.copy(order = order)), if (order == state.order) true else null)
        }
        val rows = channels.ranked(parts, state.order).map { channel ->
            rowOf(channel.name, listOf(channel.chargeText, channel.peakText, channel.shareText).map { Cell(it) })
        }
        return table("channels", listOf(Column(channels.what)) + columns + Column("Share"), rows)
    }

    private fun partsOf(line: MeasuredLine) = parts.map { Span(it.from - line.offset, it.to - line.offset) }

    private fun row(line: MeasuredLine, cells: List<Cell>, tools: List<Button> = emptyList(), continues: Boolean = false) =
        rowOf(line.name, cells, line.line.unit, line.log, line.color, continues, tools)

    private fun table(key: String, columns: List<Column>, rows: List<TableRow>) =
        if (rows.isEmpty()) emptyList() else listOf(Table(key, columns, listOf(RowGroup(rows))))

    private companion object {
        val LANES = StateTime.TITLES.map { Column(it) }
    }
}

/**
 * A part of x for statistics, and its label.
 *
 * @property span from its start to its end.
 * @property parts the parts of [span] that count; they do not touch.
 */
data class NamedSpan(val name: String, val span: Span, val parts: List<Span> = listOf(span)) {
    /** Returns its label, its length, and its ends on [axis]: `Selection: 2.5 s (1.25 – 3.75 s)`. */
    fun text(axis: XAxis): String {
        val (from, to) = listOf(span.from, span.to).map { placeText(it, axis, span.width) }
        return "$name: ${withUnit(placeText(parts.sumOf { it.width }, axis, span.width), axis.unit)} ($from – ${withUnit(to, axis.unit)})"
    }
}

/** Returns the selection at this place, otherwise the range between both cursors, otherwise the visible range. */
val Place.measured: NamedSpan
    get() = selection?.let { NamedSpan("Selection", it) }
        ?: cursors.between?.let { NamedSpan(Cursors.BETWEEN, it) }
        ?: NamedSpan("Visible range", range.visible)

/** Returns the part of the log that [wanted] selects at this place. [enabled] is the time when the robot was enabled; empty if unknown. */
fun Place.spanOf(wanted: StatisticsRange, enabled: List<EnabledSpan>): NamedSpan = when (wanted) {
    StatisticsRange.ENABLED -> joined(enabled.map { it.span }).let { parts ->
        if (parts.isEmpty()) measured else NamedSpan("Time enabled", Span(parts.first().from, parts.last().to), parts)
    }

    StatisticsRange.SHOWN -> measured

    StatisticsRange.ALL -> NamedSpan("Whole log", range.full)
}

/** Returns [spans] in the order of x; those that touch are joined. */
private fun joined(spans: List<Span>): List<Span> = buildList {
    for (span in spans.sortedBy { it.from }) {
        val before = lastOrNull()
        if (before != null && span.from <= before.to) set(lastIndex, Span(before.from, maxOf(before.to, span.to))) else add(span)
    }
}
