package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.ToolException
import badlog.assistant.log.LogLake
import badlog.cli.plugin.SeasonException
import badlog.cli.plugin.SqlColumn
import badlog.cli.plugin.SqlSession
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import java.util.Timer
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.concurrent.schedule

/**
 * Answers SQL over the tables of all logs.
 *
 * @param maxSeconds the maximum time of a query, in s.
 */
internal class SqlOverLogs(private val lake: LogLake, private val maxSeconds: Long = MAX_SECONDS) :
    AssistantTool(
        "sql",
        "Query all logs with SQL",
        "Answers a query in DuckDB's SQL over tables of all logs: matches, topics, statistics, match_statistics, samples, series, events " +
            "and findings. Without “query” it lists the tables and their columns. Good for many logs at once; the first call makes the " +
            "tables, which may take a while. Nothing can be changed, and nothing else can be read. A query may take $maxSeconds s.",
        listOf(
            Parameter("query", ParameterType.TEXT, "A single SELECT; default: list the tables."),
            Parameter("limit", ParameterType.WHOLE, "Maximum number of rows, 1 to $MAX_ROWS; default $DEFAULT_ROWS."),
        ),
    ) {
    override fun answer(arguments: Arguments): Answer {
        val limit = arguments.whole("limit", DEFAULT_ROWS, 1..MAX_ROWS)
        val query = arguments.text("query")
        return lake.asking { tables, missing -> Answer(if (query == null) tablesOf(tables) else rowsOf(tables, query, limit, missing)) }
    }

    private fun tablesOf(session: SqlSession): JsonObject = buildJsonObject {
        putJsonArray("tables") {
            for (table in session.tables()) {
                addJsonObject {
                    put("name", table.name)
                    put("meaning", table.meaning)
                    putJsonArray("columns") { table.columns.take(MAX_COLUMNS).forEach { add(titleOf(it)) } }
                    if (table.columns.size > MAX_COLUMNS) put("moreColumns", table.columns.size - MAX_COLUMNS)
                }
            }
        }
    }

    private fun rowsOf(session: SqlSession, query: String, limit: Int, missing: Int): JsonObject {
        var columns = emptyList<SqlColumn>()
        val rows = ArrayList<JsonArray>()
        var size = 0
        var isCut = false
        val watch = Timer("badlog-sql", true)
        val isLate = AtomicBoolean()
        watch.schedule(maxSeconds * MILLISECONDS) {
            isLate.set(true)
            session.cancel()
        }
        try {
            session.query(query, { columns = it }) { cells ->
                val row = JsonArray(cells)
                size += row.toString().length
                isCut = rows.size == limit || (size > MAX_CHARACTERS && rows.isNotEmpty())
                if (!isCut) rows += row
                !isCut
            }
        } catch (e: SeasonException) {
            throw if (isLate.get()) ToolException("The query took longer than $maxSeconds s; ask about fewer logs or rows.") else e
        } finally {
            watch.cancel()
        }
        return buildJsonObject {
            putJsonArray("columns") { columns.forEach { add(titleOf(it)) } }
            put("rows", JsonArray(rows))
            if (isCut) put("more", "There are more rows; select fewer columns, or continue with OFFSET ${rows.size} in an ordered query.")
            if (missing > 0) put("logsNotRead", missing)
        }
    }

    private fun titleOf(column: SqlColumn) = "${column.name} ${column.type.take(MAX_TYPE)}"
}

private const val MAX_SECONDS = 30L
private const val MILLISECONDS = 1_000L
private const val MAX_ROWS = 200
private const val DEFAULT_ROWS = 50
private const val MAX_COLUMNS = 40

/** The maximum length of a type in an answer: types of structs list all their fields. */
private const val MAX_TYPE = 60
private const val MAX_CHARACTERS = 24_000
