package badlog.season.sql

import badlog.season.engine.Engine
import badlog.season.engine.literal
import badlog.season.engine.run
import badlog.season.lake.Lake
import badlog.season.lake.LakeException
import badlog.season.lake.LakeMark
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.duckdb.DuckDBConnection
import java.nio.file.Path
import java.sql.ResultSet
import java.sql.SQLException

/**
 * Thrown if a query cannot be answered. The message is for its author, and names the problem and its place.
 *
 * @property isMistake whether the query is wrong; otherwise its files cannot be read or written, memory is missing, or it was canceled.
 */
class SqlException(override val message: String, cause: Throwable? = null, val isMistake: Boolean = true) : Exception(message, cause)

/**
 * A column of an answer.
 *
 * @property type its SQL type.
 */
class SqlColumn internal constructor(val name: String, val type: String) {
    /** Whether it has numbers, which are aligned to the right. */
    val isNumeric: Boolean get() = NUMERIC.any { type.startsWith(it) }

    private companion object {
        val NUMERIC = listOf("DOUBLE", "FLOAT", "DECIMAL", "BIGINT", "INTEGER", "SMALLINT", "TINYINT", "HUGEINT", "UBIGINT", "UINTEGER")
    }
}

/**
 * SQL over a lake, by DuckDB in this process. A query can only read the lake: it cannot change anything, see other files, or reach a
 * network. Not thread-safe, except for [cancel].
 */
class LakeDatabase private constructor(
    private val folder: Path,
    private val output: Path?,
    private val isConfined: Boolean,
    private val engine: Engine,
    private val connection: DuckDBConnection,
) : AutoCloseable {
    private val views = LakeViews(folder, connection, hidden = if (isConfined) setOf("path") else emptySet())

    @Volatile
    private var running: java.sql.Statement? = null

    /**
     * Answers [sql], a single query.
     *
     * @param columns receives the columns before the rows.
     * @param row receives each row: numbers, texts, true and false, null, lists and objects; times as texts in UTC. Returning false
     * ends the answer.
     * @throws SqlException if it is not a query, or cannot be answered.
     */
    fun query(sql: String, columns: (List<SqlColumn>) -> Unit, row: (List<JsonElement>) -> Boolean): Unit = asking(sql) {
        connection.createStatement().use { statement ->
            running = statement
            try {
                statement.executeQuery(sql).use { rows -> passRows(rows, columns, row) }
            } finally {
                running = null
            }
        }
    }

    /**
     * Writes the answer to [sql], a single query, to the Parquet file that was named when this was opened.
     *
     * @return the number of rows.
     * @throws SqlException if it is not a query, cannot be answered, or the file cannot be written.
     */
    fun writeParquet(sql: String): Long = asking(sql) {
        val target = checkNotNull(output) { "No file was named." }
        connection.run("CREATE OR REPLACE TEMP VIEW badlog_answer AS $sql")
        connection.run("COPY (SELECT * FROM badlog_answer) TO ${literal("$target")} (FORMAT parquet, COMPRESSION zstd)")
    }

    /** Returns the tables that queries can use, each with its name, the meaning of a row, and its columns. */
    fun tables(): List<SqlTable> = LakeView.entries.map { view ->
        views.make(view)
        var found = emptyList<SqlColumn>()
        query("SELECT * FROM ${view.sqlName} LIMIT 0", { found = it }) { true }
        SqlTable(view.sqlName, view.meaning, found)
    }

    /** Cancels the query that is running on another thread, which then throws. */
    fun cancel() {
        running?.cancel()
    }

    private fun passRows(rows: ResultSet, columns: (List<SqlColumn>) -> Unit, row: (List<JsonElement>) -> Boolean) {
        val described = rows.metaData
        columns((1..described.columnCount).map { SqlColumn(described.getColumnLabel(it), described.getColumnTypeName(it)) })
        while (rows.next()) if (!row((1..described.columnCount).map { jsonOf(rows.getObject(it)) })) return
    }

    private fun <R> asking(sql: String, work: () -> R): R = try {
        requireQuery(sql)
        views.makeFor(sql)
        work()
    } catch (e: SQLException) {
        // If rows are streamed, the driver adds a line of its own before the engine's message.
        val message = e.message.orEmpty().substringAfter("\nError: ").trim()
        val isMistake = ENGINE_FAILURES.none { it in message.substringBefore(':') }
        throw SqlException(if (isConfined) message.replace("$folder", "the lake") else message, e, isMistake)
    }

    /** Only queries can be written as JSON by DuckDB, so anything else is refused before any of it is executed. */
    private fun requireQuery(sql: String) {
        val parsed = connection.createStatement().use { statement ->
            statement.executeQuery("SELECT json_serialize_sql(${literal(sql)})").use { rows ->
                rows.next()
                Json.parseToJsonElement(rows.getString(1)).jsonObject
            }
        }
        if (parsed["error"]?.jsonPrimitive?.content == "true") {
            val message = parsed["error_message"]?.jsonPrimitive?.content.orEmpty()
            throw SqlException(if ("SELECT" in message) ONLY_QUERIES else "The query is wrong: $message")
        }
        if (parsed["statements"]?.jsonArray?.size != 1) throw SqlException(ONLY_QUERIES)
        if (isConfined) QuerySources.require(parsed)
    }

    override fun close() {
        connection.close()
        engine.close()
    }

    companion object {
        /**
         * Opens [lake].
         *
         * @param output a file that [writeParquet] may write; null for none.
         * @param isConfined whether the people who ask must not learn where files are, and may use little memory. Queries can then only
         *   read the [tables], which do not show where files are.
         * @throws LakeException if it is not a lake.
         */
        fun open(lake: Lake, output: Path? = null, isConfined: Boolean = false): LakeDatabase {
            LakeMark.of(lake.folder) ?: throw LakeException("${lake.folder} is not a lake; make one with badlog lake.")
            // Queries could not access it by another path.
            val folder = lake.folder.toRealPath()
            val target = output?.toAbsolutePath()?.normalize()
            val memory = if (isConfined) CONFINED_MEGABYTES else null
            val engine = Engine(memory, threads = Runtime.getRuntime().availableProcessors(), streams = true)
            try {
                engine.lockTo(listOf(folder), listOfNotNull(target))
                return LakeDatabase(folder, target, isConfined, engine, engine.connection())
            } catch (e: SQLException) {
                engine.close()
                throw LakeException("The lake $folder cannot be read (${e.message}); make it again.", e)
            }
        }

        private const val CONFINED_MEGABYTES = 1024

        /** The beginnings of messages about failures that are not mistakes in the query. */
        private val ENGINE_FAILURES =
            listOf("IO Error", "Out of Memory", "INTERRUPT", "INTERNAL", "FATAL", "Connection Error", "Permission Error")
        private const val ONLY_QUERIES = "Only a single query is possible here, such as SELECT … FROM matches; nothing can be changed."
    }
}

/**
 * A table that queries can use.
 *
 * @property meaning the meaning of a row.
 */
class SqlTable internal constructor(val name: String, val meaning: String, val columns: List<SqlColumn>)
