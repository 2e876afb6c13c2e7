package badlog.season.engine

import org.duckdb.DuckDBConnection
import org.duckdb.DuckDBDriver
import org.duckdb.DuckDBFunctions
import java.nio.file.Path
import java.util.Properties

/**
 * A DuckDB in this process; its only sources are files and the tables passed to [lend]. Data that does not fit in its memory goes to a
 * folder for temporary files, which [close] removes.
 *
 * @param memoryMegabytes its maximum memory; null for most of the machine's.
 * @param threads the number of threads for a single query, including the caller's.
 * @param streams whether rows of results are returned as they are found, rather than all at the end.
 */
internal class Engine(memoryMegabytes: Int?, threads: Int, streams: Boolean = false) : AutoCloseable {
    init {
        requireEngine()
    }

    private val scratch = ScratchFolder()
    private val tables = LentTables()
    private val root: DuckDBConnection = connected(if (streams) mapOf(DuckDBDriver.JDBC_STREAM_RESULTS to "true") else emptyMap())

    init {
        root.run(
            "SET threads = $threads",
            "SET temp_directory = ${literal("${scratch.path}")}",
            // Nothing is ever downloaded.
            "SET autoinstall_known_extensions = false",
            "SET autoload_known_extensions = false",
            "SET TimeZone = 'UTC'",
        )
        if (memoryMegabytes != null) root.run("SET memory_limit = '${memoryMegabytes}MB'")
        DuckDBFunctions.tableFunction().withName(LentTables.FUNCTION).withParameter(Long::class.javaPrimitiveType)
            .withFunction(tables).register(root)
    }

    /** Returns another connection, which must be closed. */
    fun connection(): DuckDBConnection = root.duplicate().unwrap(DuckDBConnection::class.java)

    /** Runs [work] with a connection for this thread only. */
    fun <R> connected(work: (DuckDBConnection) -> R): R = connection().use(work)

    /** Lets [use] read [table] with the SQL that it receives. */
    fun <R> lend(table: Table, use: (select: String) -> R): R = tables.lend(table, use)

    /** Permanently restricts queries to [folders] and the files [files]; nothing else on the disk or a network can be read. */
    fun lockTo(folders: List<Path>, files: List<Path>) = root.run(
        "SET allowed_directories = [${folders.joinToString { literal("$it/") }}]",
        "SET allowed_paths = [${files.joinToString { literal("$it") }}]",
        "SET enable_external_access = false",
        "SET lock_configuration = true",
    )

    /** Runs [work], which writes files. If the program is asked to end meanwhile, [finish] runs first, see [ScratchFolder.finishing]. */
    fun <R> finishing(finish: () -> Unit, work: () -> R): R = scratch.finishing(finish, work)

    override fun close() {
        root.close()
        scratch.close()
    }

    companion object {
        /** The memory for writing a lake, in MB. */
        const val WRITING_MEGABYTES = 256
    }
}

private fun connected(options: Map<String, String>): DuckDBConnection =
    DuckDBDriver().connect("jdbc:duckdb:", Properties().apply { putAll(options) }).unwrap(DuckDBConnection::class.java)

/** Executes [statements], one after the other. Returns the number of rows that the last one changed or wrote. */
internal fun DuckDBConnection.run(vararg statements: String): Long = createStatement().use { statement ->
    for (sql in statements) statement.execute(sql)
    statement.largeUpdateCount
}

/** Returns [text] as an SQL literal. */
internal fun literal(text: String): String = "'${text.replace("'", "''").replace(NUL, "")}'"

/** Returns [text], or NULL, as an SQL literal. */
internal fun literalOrNull(text: String?): String = text?.let(::literal) ?: "NULL::VARCHAR"

/** Returns [name] as a quoted SQL identifier. */
internal fun quoted(name: String): String = "\"${name.replace("\"", "\"\"").replace(NUL, "")}\""

/** DuckDB would end a text at this character. */
private const val NUL = "\u0000"
