package badlog.viewer.panel.folder

import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Units
import badlog.core.recording.Topic
import badlog.viewer.catalog.ListedLog
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Column
import badlog.viewer.panel.Extreme
import badlog.viewer.panel.Field
import badlog.viewer.panel.Part
import badlog.viewer.panel.Row
import badlog.viewer.panel.RowGroup
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.state.AcrossColumn
import badlog.viewer.state.AcrossState
import badlog.viewer.state.FolderAction
import badlog.viewer.state.TopicsState
import badlog.viewer.text.countText
import badlog.viewer.text.exactText
import badlog.viewer.text.shortNames
import badlog.viewer.text.withUnit

/**
 * A log in the statistics across logs.
 *
 * @property label the match, or otherwise the name of the file.
 * @property date the time when it was recorded, as text that sorts by time; empty if unknown.
 * @property path its file.
 * @property statistics the statistics of each requested topic that it has, by name.
 * @property units the units of these topics, by name; `ul` for none.
 * @property xUnit the unit of its x axis; null if unknown.
 */
class AcrossLog(
    val label: String,
    val date: String,
    val path: String,
    val statistics: Map<String, SeriesStatistics>,
    val units: Map<String, String>,
    val xUnit: String? = null,
)

/** The statistics of [logs] in the order of [state]; logs without a value always come last. */
class AcrossLogs(logs: List<AcrossLog>, private val state: AcrossState) {
    private val logs = sorted(logs)
    private val figures = state.figures.map { FigureFacts(it, logs) }

    /** Returns the table. The smallest and the largest value of a column are marked, unless all are the same. */
    fun table(): Table {
        val names = state.topics.zip(shortNames(state.topics)).toMap()
        val facts = listOf(column(AcrossColumn.Label, "Log", ""), column(AcrossColumn.Date, "Date", ""))
        val columns = facts + figures.map { column(it.column, "${names[it.column.topic]}\n${it.title}", it.name) }
        val rows = logs.map { log ->
            val texts = listOf(Cell(log.label, log.path), Cell(log.date))
            val open = FolderAction.Open(log.path, showsFinding = false)
            TableRow("Log ${log.label}", (texts + figures.map { it.cell(log) }).map(::listOf), log.path, open = open)
        }
        return Table("across", columns, listOf(RowGroup(rows)), "Statistics across logs")
    }

    /**
     * Returns the table as CSV (RFC 4180): exact values, and an empty cell for none. A column with several units is followed by a column
     * with the units.
     */
    fun csv(): String {
        val head = listOf("Log", "Date", "File") + figures.flatMap { figure ->
            if (figure.unit == null) listOf(figure.name, "${figure.name} unit") else listOf(named(figure.name, figure.unit))
        }
        val lines = logs.map { log ->
            listOf(log.label, log.date, log.path) + figures.flatMap { figure ->
                val value = figure.of(log).let { if (it.isNaN()) "" else exactText(it) }
                if (figure.unit == null) listOf(value, figure.unitIn(log)) else listOf(value)
            }
        }
        return (listOf(head) + lines).joinToString("") { line -> line.joinToString(",", postfix = "\r\n", transform = ::csvCell) }
    }

    private fun column(column: AcrossColumn, title: String, hint: String): Column {
        val isDescending = if (state.sort == column) state.isDescending else null
        val sort = FolderAction.MeasureAcross(state.sortedBy(column))
        return Column(title, hint, sort, isDescending, isNumber = column is AcrossColumn.Figure)
    }

    private fun sorted(logs: List<AcrossLog>): List<AcrossLog> = when (val column = state.sort) {
        null -> logs

        AcrossColumn.Label -> logs.sortedWith(directed(compareBy(String.CASE_INSENSITIVE_ORDER) { it.label }))

        AcrossColumn.Date -> logs.sortedWith(directed(compareBy { it.date }))

        is AcrossColumn.Figure -> {
            val (without, with) = logs.partition { column.of(it).isNaN() }
            with.sortedWith(directed(compareBy { column.of(it) })) + without
        }
    }

    private fun directed(order: Comparator<AcrossLog>) = if (state.isDescending) order.reversed() else order
}

/** A [column] over [logs]; [unit] is null if they differ. */
private class FigureFacts(val column: AcrossColumn.Figure, logs: List<AcrossLog>) {
    private val values = logs.map(::of).filter { it.isFinite() }
    private val least = values.minOrNull()
    private val most = values.maxOrNull()
    private val units = logs.filter { column.topic in it.units }.map(::unitIn).distinct()
    val unit: String? = if (units.size > 1) null else units.firstOrNull() ?: Topic.UNITLESS
    val name: String = "${column.topic} ${column.statistic.title}"
    val title: String = named(column.statistic.title, unit ?: Topic.UNITLESS)

    fun of(log: AcrossLog) = column.of(log)

    fun unitIn(log: AcrossLog): String = log.units[column.topic]?.let { column.statistic.unitOf(it, log.xUnit) }.orEmpty()

    fun cell(log: AcrossLog): Cell {
        val value = of(log)
        val extreme = when {
            least == most -> null
            value == least -> Extreme.SMALLEST
            value == most -> Extreme.LARGEST
            else -> null
        }
        val own = if (unit == null) unitIn(log) else Topic.UNITLESS
        return Cell(withUnit(column.statistic.textOf(value), own), withUnit(exactText(value), own), extreme = extreme)
    }
}

/** Returns [text] as a cell of CSV: quoted if necessary. */
private fun csvCell(text: String) = if (text.any { it in ",\"\r\n" }) "\"" + text.replace("\"", "\"\"") + "\"" else text

private fun AcrossColumn.Figure.of(log: AcrossLog): Double = log.statistics[topic]?.let(statistic::of) ?: Double.NaN

private fun named(name: String, unit: String) = if (Units.isNone(unit)) name else "$name ($unit)"

/** Returns the choices of the logs and statistics of [state]. */
fun acrossTools(state: AcrossState): List<Button> {
    fun over(label: String, all: Boolean, hint: String) =
        Button(label, FolderAction.MeasureAcross(state.copy(isOverAll = all)), hint = hint, isOn = state.isOverAll == all)
    val logs = listOf(
        over("Checked", all = false, "The open log and those that are checked"),
        over("All", all = true, "Every log of the folder"),
    )
    return logs + Statistic.entries.map {
        Button(it.title, FolderAction.MeasureAcross(state.toggled(it)), hint = "Column ${it.title}", isOn = it in state.statistics)
    }
}

/**
 * Returns the choice of topics for [state] among those that its search has [found]; the selected ones come first, so that they can always
 * be found.
 */
fun acrossTopics(state: AcrossState, found: List<String>): List<Part> {
    val rows = (state.topics + (found - state.topics.toSet())).map { topic ->
        val toggle = FolderAction.MeasureAcross(state.toggled(topic))
        Row(topic, severity = null, "Statistics of $topic", topic, emptyList(), isCurrent = topic in state.topics, open = toggle)
    }
    val field = Field("search", "Search topics for the table", text = state.search, isSearch = true) {
        FolderAction.MeasureAcross(state.copy(search = it))
    }
    return listOf(field, Rows("topics", "Topics", rows, isLong = true))
}

/** Returns one statistic of each topic in [logs] beside each other, each over its whole log. */
fun topicsOfLogs(logs: List<ListedLog>, state: TopicsState): List<Part> {
    val choices = Statistic.entries.map {
        Button(it.title, FolderAction.MeasureTopics(state.copy(statistic = it)), isOn = it == state.statistic)
    }
    val field = Field("topic-filter", "Search topics of the statistics", text = state.search, isSearch = true) {
        FolderAction.MeasureTopics(state.copy(search = it))
    }
    val query = Query(state.search)
    val topics = logs.map { log -> log.summary.topics.associateBy { it.name } }
    val names = topics.flatMapTo(LinkedHashSet()) { it.keys }.filter { query.isEmpty || query.matches(it) }
    // Matches of different events may have the same title.
    val areDistinct = logs.distinctBy { it.title }.size == logs.size
    val columns = logs.mapIndexed { i, log ->
        Column(if (areDistinct) log.title else log.fileName, log.path, isNumber = true, key = "log $i")
    }
    val rows = names.take(state.limit).map { name ->
        val values = topics.map { of -> of[name]?.let { state.statistic.of(it.statistics) } }
        val unit = topics.firstNotNullOf { it[name] }.unit
        val subject = Cell(if (unit.isEmpty() || Units.isNone(unit)) name else "$name [$unit]")
        val cells = values.map { if (it == null) Cell("") else Cell(state.statistic.textOf(it), exactText(it)) }
        TableRow(name, (listOf(subject) + cells).map(::listOf), name)
    }
    val left = names.size - state.limit
    val more = Button("Show more (${countText(left)} left)", FolderAction.MeasureTopics(state.copy(limit = state.limit + TopicsState.PAGE)))
    return listOfNotNull(
        Choice("statistic", "Statistic", choices),
        field,
        Table("topics", listOf(Column("Topic")) + columns, listOf(RowGroup(rows))),
        if (left > 0) Buttons("more", listOf(more)) else null,
    )
}
