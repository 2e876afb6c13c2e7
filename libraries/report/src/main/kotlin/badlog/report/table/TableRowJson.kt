package badlog.report.table

import badlog.report.HookFailureJson
import badlog.report.finite
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.JsonPrimitive

/** A row of a [MatchTable] in the form for other programs. Unknown numbers are null. */
@Serializable
class TableRowJson private constructor(
    private val match: String?,
    private val by: Map<String, String>,
    private val values: Map<String, Double?>,
    private val units: Map<String, String>,
    private val messages: Map<String, String>,
    private val hooks: Map<String, Map<String, JsonPrimitive>>,
    private val hookFailures: List<HookFailureJson>,
) {
    constructor(table: MatchTable, row: TableRow) : this(
        match = row.title,
        by = table.by.zip(row.headers).toMap(),
        values =
        table.questions.zip(row.cells.map { finite(it.value) }).toMap() + row.topics.associate { it.title to finite(it.cell.value) },
        units = table.questions.zip(row.cells.map { it.unit }).toMap() + row.topics.associate { it.title to it.cell.unit },
        messages = table.questions.zip(row.cells).mapNotNull { (question, cell) -> cell.refusal?.let { question to it.message } }.toMap(),
        hooks = row.hookValues.groupBy { it.hook }.mapValues { (_, values) -> values.associate { it.name to primitive(it.text) } },
        hookFailures = row.hookFailures.map { HookFailureJson(it.hook, it.message) },
    )
}

private fun primitive(text: String): JsonPrimitive = finite(text.toDoubleOrNull())?.let(::JsonPrimitive) ?: JsonPrimitive(text)
