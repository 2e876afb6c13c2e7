package badlog.season.engine

import org.duckdb.DuckDBDataChunkWriter
import org.duckdb.DuckDBTableFunction
import org.duckdb.DuckDBTableFunctionBindInfo
import org.duckdb.DuckDBTableFunctionCallInfo
import org.duckdb.DuckDBTableFunctionInitInfo
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicLong

/**
 * A table that Java holds and DuckDB reads, piece by piece, without a copy of all of it.
 *
 * @property rowCount the number of rows.
 * @property constants columns with the same value in each row, which come before the others: their names, and the SQL of their
 * values.
 */
internal class Table(val columns: List<Column>, val rowCount: Int, val constants: List<Pair<String, String>> = emptyList()) {
    /** Returns the SQL that selects all of it from [source]. */
    fun select(source: String): String {
        val all = constants.map { (name, sql) -> sql to name } + columns.map { it.sql(quoted(it.name)) to it.name }
        return "SELECT ${all.joinToString { (sql, name) -> "$sql AS ${quoted(name)}" }} FROM $source"
    }
}

/** The tables that DuckDB can currently read, each with a number. Thread-safe. */
internal class LentTables : DuckDBTableFunction<Table, LentTables.Cursor, Any?> {
    private val tables = ConcurrentHashMap<Long, Table>()
    private val last = AtomicLong()

    /** A query's position in its table. */
    class Cursor {
        var next = 0
    }

    /** Lets DuckDB read [table] while [use] runs, which receives the SQL that selects all of it. */
    fun <R> lend(table: Table, use: (select: String) -> R): R {
        val key = last.incrementAndGet()
        tables[key] = table
        try {
            return use(table.select("$FUNCTION($key)"))
        } finally {
            tables.remove(key)
        }
    }

    override fun bind(info: DuckDBTableFunctionBindInfo): Table {
        val table = checkNotNull(tables[info.getParameter(0).long]) { "This table is not there any longer." }
        for (column in table.columns) info.addResultColumn(column.name, column.type)
        info.setCardinality(table.rowCount.toLong(), true)
        return table
    }

    override fun init(info: DuckDBTableFunctionInitInfo): Cursor {
        info.setMaxThreads(1)
        return Cursor()
    }

    override fun apply(info: DuckDBTableFunctionCallInfo, output: DuckDBDataChunkWriter): Long {
        val table = info.getBindData<Table>()
        val cursor = info.getInitData<Cursor>()
        val size = minOf(output.capacity(), (table.rowCount - cursor.next).toLong()).toInt()
        table.columns.forEachIndexed { i, column -> column.write(output.vector(i.toLong()), cursor.next, size) }
        cursor.next += size
        return size.toLong()
    }

    companion object {
        /** Its name in SQL. */
        const val FUNCTION = "badlog_table"
    }
}
