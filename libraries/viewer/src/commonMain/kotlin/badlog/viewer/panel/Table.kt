package badlog.viewer.panel

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.core.recording.Topic
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.state.Action

/**
 * A table, called [name] by screen readers; empty if its surroundings name it. The first of its [columns] has the subjects of its rows.
 * Without room for its columns, its rows are cards.
 */
class Table(override val key: String, val columns: List<Column>, val groups: List<RowGroup>, val name: String = "") : Part {
    /** All its rows. */
    val rows: List<TableRow> get() = groups.flatMap { it.rows }

    /** Returns this table without its minor columns, for a place without room for all of them. */
    fun withoutMinor(): Table {
        fun <T> List<T>.major() = filterIndexed { i, _ -> !columns[i].isMinor }
        val shorter = groups.map { group -> RowGroup(group.rows.map { it.copy(cells = it.cells.major()) }, group.title, group.count) }
        return Table(key, columns.major(), shorter, name)
    }
}

/**
 * A column of a table.
 *
 * @property title its title; a person sees its lines below each other.
 * @property hint an explanation of its title; empty for none.
 * @property sort the effect of a press on its title; null for none.
 * @property isDescending the order of the rows, if they are sorted by it; otherwise null.
 * @property key its identity among the columns.
 * @property isMinor whether it is left out first where there is no room for all columns.
 */
class Column(
    val title: String,
    val hint: String = "",
    val sort: Action? = null,
    val isDescending: Boolean? = null,
    val isNumber: Boolean = false,
    val key: String = title,
    val isMinor: Boolean = false,
)

/** The [rows] of a table under a common [title], with their [count]; an empty title is not shown. */
class RowGroup(val rows: List<TableRow>, val title: String = "", val count: String = "")

/**
 * A row of a table, called [name] by screen readers.
 *
 * @property cells for each column, its cells, below each other; without a subject, the row is about the one before.
 * @property key its identity in the table; empty if it is its position.
 * @property unit the unit of the line it is about; `ul` for none.
 * @property log the name of the log it is about; empty if there is only one.
 * @property checks its check boxes, below each other.
 * @property open the effect of a press on the row; null for none.
 * @property isMuted whether there is nothing to see in it.
 */
data class TableRow(
    val name: String,
    val cells: List<List<Cell>>,
    val key: String = "",
    val unit: String = Topic.UNITLESS,
    val log: String = "",
    val checks: List<Check> = emptyList(),
    val open: Action? = null,
    val isMuted: Boolean = false,
)

/** Returns a row of [figures] about [name]; about the row before if it [continues]. [color] is the index of the color of its line. */
fun rowOf(
    name: String,
    figures: List<Cell>,
    unit: String = Topic.UNITLESS,
    log: String = "",
    color: Int? = null,
    continues: Boolean = false,
    tools: List<Button> = emptyList(),
): TableRow {
    val subject = when {
        continues -> emptyList()
        log.isEmpty() -> listOf(Cell(name, color = color, tools = tools))
        else -> listOf(Cell(name, tools = tools), Cell(log, color = color))
    }
    return TableRow(name, listOf(subject) + figures.map(::listOf), unit = unit, log = log)
}

/** A check box, called [label] by screen readers. */
data class Check(val label: String, val isOn: Boolean, val action: Action)

/**
 * A cell of a table.
 *
 * @property hint its value to the last digit, or an explanation.
 * @property unit its unit, which a table below a graph does not repeat; `ul` for none.
 * @property open the effect of a press on it; null for the effect of the row.
 * @property isUnfolded whether the rows below belong to it and are shown; null if there are none.
 * @property severity its severity, in color, and without a [share] also as a shape and word; null if it does not matter.
 * @property share the length of a bar beside it, 0 to 1; null for none.
 * @property extreme whether it is the smallest or largest of its column; null for neither.
 * @property preview the shape of a series; null for none.
 * @property color the index of the color of its line; null for none.
 * @property tools its buttons.
 */
data class Cell(
    val text: String,
    val hint: String = text,
    val unit: String = Topic.UNITLESS,
    val open: Action? = null,
    val isUnfolded: Boolean? = null,
    val severity: Severity? = null,
    val share: Double? = null,
    val extreme: Extreme? = null,
    val preview: Preview? = null,
    val color: Int? = null,
    val tools: List<Button> = emptyList(),
)

/** The extremes of a column. */
enum class Extreme { SMALLEST, LARGEST }

/** The shape of the series of [topic], drawn with the [range] of y from bottom to top. */
data class Preview(val topic: TopicSummary, val range: Span) {
    /**
     * Its lines, each as x and y of its points in turn. They are shares of the width and height, from the left and the top. A column
     * without values is between two lines.
     */
    val lines: List<DoubleArray> by lazy {
        val lines = ArrayList<ArrayList<Double>>()
        for (column in 0 until PreviewLine.COLUMNS) {
            if (!topic.preview.has(column)) continue
            if (column == 0 || !topic.preview.has(column - 1)) lines += ArrayList<Double>()
            lines.last().addColumn(column)
        }
        lines.map { it.toDoubleArray() }
    }

    /** Adds the two ends of [column], first the end that is nearer to the last point. */
    private fun MutableList<Double>.addColumn(column: Int) {
        val low = placeOf(topic.preview.low(column))
        val high = placeOf(topic.preview.high(column))
        val last = lastOrNull() ?: high
        val beginsLow = last - high > low - last
        addAll(listOf((column + 0.25) / PreviewLine.COLUMNS, if (beginsLow) low else high))
        addAll(listOf((column + 0.75) / PreviewLine.COLUMNS, if (beginsLow) high else low))
    }

    private fun placeOf(share: Float): Double {
        val value = with(topic.statistics) { min + (max - min) * share }
        val place = if (range.width > 0) (value - range.from) / range.width else 0.5
        return 1 - (if (place.isNaN()) 0.5 else place).coerceIn(0.0, 1.0)
    }
}
