package badlog.window.sidebar

import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Units
import badlog.core.recording.Topic
import badlog.viewer.text.exactText
import badlog.viewer.text.shortNames
import badlog.viewer.text.withUnit
import java.nio.file.Path

/**
 * The table of statistics, ready to be shown or exported.
 *
 * @property columns its columns, from left to right.
 * @property rows its rows, sorted according to the choice; rows without a value always come last.
 */
internal class StatisticsGrid(rows: List<StatisticsRow>, choice: StatisticsChoice) {
    val columns: List<StatisticsColumn> = choice.columns
    val rows: List<StatisticsRow> = sorted(rows, choice)

    private val figures = columns.filterIsInstance<FigureColumn>().associateWith { column ->
        val values = rows.map { column.of(it) }.filter { it.isFinite() }
        val units = rows.filter { column.topic in it.units }.map { column.unitIn(it) }.distinct()
        FigureFacts(values.minOrNull() ?: Double.NaN, values.maxOrNull() ?: Double.NaN, units)
    }

    private val names = choice.topics.zip(shortNames(choice.topics)).toMap()

    /** Returns the name of the topic in the heading of [column]. It is the part of its path that distinguishes it from the others. */
    fun nameOf(column: FigureColumn): String = names.getValue(column.topic)

    /** Returns the common unit of [column]; null if recordings differ. */
    fun unitOf(column: FigureColumn): String? {
        val units = figures.getValue(column).units
        return if (units.size > 1) null else units.firstOrNull() ?: Topic.UNITLESS
    }

    /** Returns whether the value of [row] is the smallest of [column], and not all are the same. */
    fun isLowest(column: FigureColumn, row: StatisticsRow): Boolean = figures.getValue(column).run { min < max && column.of(row) == min }

    /** Returns whether the value of [row] is the largest of [column], and not all are the same. */
    fun isHighest(column: FigureColumn, row: StatisticsRow): Boolean = figures.getValue(column).run { min < max && column.of(row) == max }

    /** Returns the text of [column] in [row], with the unit only if the column does not have a single one. */
    fun textOf(column: StatisticsColumn, row: StatisticsRow): String = when (column) {
        LabelColumn -> row.label

        DateColumn -> row.date

        is FigureColumn -> withUnit(
            column.statistic.textOf(column.of(row)),
            if (unitOf(column) == null) column.unitIn(row) else Topic.UNITLESS,
        )
    }

    /**
     * Returns the table as CSV (RFC 4180): exact values, and an empty cell for none. A column with several units is followed by a column
     * with the units.
     */
    fun toCsv(): String {
        val head = ArrayList(listOf("Log", "Date", "File"))
        for ((column, facts) in figures) {
            val name = "${column.topic} ${column.statistic.title}"
            val unit = facts.units.firstOrNull() ?: Topic.UNITLESS
            head += when {
                facts.units.size > 1 -> listOf(name, "$name unit")
                Units.isNone(unit) -> listOf(name)
                else -> listOf("$name ($unit)")
            }
        }
        val lines = rows.map { row ->
            listOf(row.label, row.date, row.path.toString()) + figures.flatMap { (column, facts) ->
                val value = column.of(row).let { if (it.isNaN()) "" else exactText(it) }
                if (facts.units.size > 1) listOf(value, if (column.topic in row.units) column.unitIn(row) else "") else listOf(value)
            }
        }
        return (listOf(head) + lines).joinToString("") { line -> line.joinToString(",", postfix = "\r\n", transform = ::csvCell) }
    }

    private class FigureFacts(val min: Double, val max: Double, val units: List<String>)
}

/** Returns [text] as a cell of CSV: quoted if necessary. */
internal fun csvCell(text: String): String = if (text.any { it in ",\"\r\n" }) "\"" + text.replace("\"", "\"\"") + "\"" else text

private fun sorted(rows: List<StatisticsRow>, choice: StatisticsChoice): List<StatisticsRow> = when (val column = choice.sort) {
    null -> rows

    LabelColumn -> rows.sortedWith(directed(choice, compareBy(String.CASE_INSENSITIVE_ORDER) { it.label }))

    DateColumn -> rows.sortedWith(directed(choice, compareBy { it.date }))

    is FigureColumn -> {
        val (without, with) = rows.partition { column.of(it).isNaN() }
        with.sortedWith(directed(choice, compareBy { column.of(it) })) + without
    }
}

private fun directed(choice: StatisticsChoice, order: Comparator<StatisticsRow>) = if (choice.isDescending) order.reversed() else order

/**
 * A recording in the table of statistics.
 *
 * @property label the match, or otherwise the name of the file.
 * @property date the time when it was recorded, as text that sorts by time; empty if unknown.
 * @property path its file.
 * @property statistics the statistics of each requested topic that it has, by name.
 * @property units the units of these topics, by name; `ul` for none.
 * @property xUnit the unit of its x axis; null if unknown.
 */
internal class StatisticsRow(
    val label: String,
    val date: String,
    val path: Path,
    val statistics: Map<String, SeriesStatistics>,
    val units: Map<String, String>,
    val xUnit: String? = null,
)
