package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Page
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.ToolException
import badlog.assistant.call.number
import badlog.assistant.call.unitOf
import badlog.assistant.log.LogFolder
import badlog.report.table.MatchTable
import badlog.report.table.TableCell
import badlog.report.table.TableRow
import badlog.viewer.text.exactText
import badlog.viewer.text.withUnit
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.add
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import java.nio.file.Path

/**
 * Makes a table with a row for each log.
 *
 * @param cache where answers are cached.
 */
internal class TableOfLogs(private val logs: LogFolder, private val cache: Path?) :
    AssistantTool(
        "table",
        "Compare logs in a table",
        "Makes a table with a row for each log and a column for each expression, such as “min(battery voltage)”, to compare matches. " +
            "“by” adds columns of header values and sorts by them; “where” keeps logs whose header values meet a condition, such as " +
            "\"Match Type = 'Qualification'\". A value that is not known is null.",
        listOf(
            Parameter("values", ParameterType.TEXTS, "The expressions, at most $MAX_COLUMNS; see the tool find.", isRequired = true),
            Parameter("by", ParameterType.TEXTS, "Names of header values, such as “Match Number”."),
            Parameter("where", ParameterType.TEXT, "A condition on header values."),
            Parameter(
                "formulas",
                ParameterType.TEXTS,
                "Topics to calculate first, each such as “Power [W] = Battery Voltage * Total Current”.",
            ),
        ) + Page.PARAMETERS,
    ) {
    override fun answer(arguments: Arguments): Answer {
        val values = arguments.texts("values")
        val by = arguments.texts("by")
        if (values.isEmpty()) throw ToolException("“values” is empty; name at least one expression, such as “min(battery voltage)”.")
        if (values.size + by.size > MAX_COLUMNS) throw ToolException("The table would have more than $MAX_COLUMNS columns; ask for fewer.")
        val all = logs.logs()
        val signals = logs.signals()
        val table = MatchTable(values, by, emptyList(), arguments.text("where"), arguments.texts("formulas"), cache, signals = signals)
        table.mistake?.let { throw ToolException(it.pointed) }
        val rows = table.over(all.values.toList())
        table.mistakeIn(rows)?.let { throw ToolException(it.pointed) }
        val nameOf = all.entries.associate { (name, file) -> file to name }
        val wanted = rows.filter { it.isWanted && it.unreadable == null }
        val units = values.indices.map { column -> wanted.map { it.cells[column].unit }.filter { it.isNotEmpty() }.distinct() }
        return Answer(
            buildJsonObject {
                putJsonArray("columns") { (listOf("log", "match") + by + values).forEach { add(it) } }
                putJsonArray("units") {
                    repeat(2 + by.size) { add(JsonNull) }
                    units.forEach { add(if (it.size > 1) "in each cell" else it.singleOrNull()?.let(::unitOf)) }
                }
                val json = { row: TableRow -> json(nameOf.getValue(row.file), row) { units[it].size > 1 } }
                Page.of(wanted, arguments) { part -> part.map(json) }.putInto(this, "rows")
                if (wanted.size < rows.size) put("leftOut", rows.size - wanted.size)
            },
        )
    }

    private fun json(name: String, row: TableRow, hasOwnUnit: (Int) -> Boolean): JsonArray = buildJsonArray {
        add(name)
        add(row.title)
        row.headers.forEach { add(it) }
        row.cells.forEachIndexed { column, cell -> add(json(cell, hasOwnUnit(column))) }
    }

    private fun json(cell: TableCell, hasOwnUnit: Boolean): JsonElement = when {
        cell.word.isNotEmpty() -> JsonPrimitive(cell.word)
        hasOwnUnit && cell.value.isFinite() -> JsonPrimitive(withUnit(exactText(cell.value), cell.unit))
        else -> number(cell.value)
    }
}

private const val MAX_COLUMNS = 12
