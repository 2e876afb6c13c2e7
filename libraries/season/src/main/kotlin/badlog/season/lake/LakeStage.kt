package badlog.season.lake

import badlog.season.engine.Engine
import badlog.season.engine.FieldType
import badlog.season.engine.RecordColumn
import badlog.season.engine.Table
import badlog.season.engine.literal
import badlog.season.engine.run
import org.duckdb.DuckDBConnection
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.UUID
import java.util.concurrent.locks.ReentrantReadWriteLock
import kotlin.concurrent.read
import kotlin.concurrent.write

/**
 * Collects the records of logs until [flush] writes them to the tables of the lake [folder], each file atomically. Thread-safe.
 */
internal class LakeStage(private val folder: Path, private val engine: Engine) {
    private val lock = ReentrantReadWriteLock()
    private val changedPartitions = LinkedHashSet<Partition>()
    private val obsolete = ArrayList<String>()
    private var waiting = Waiting()

    /** Records that are inserted into DuckDB together. */
    private class Waiting {
        val logs = ArrayList<String>()
        val records = LakeTable.entries.associateWith { ArrayList<PlacedRecord>() }
    }

    /** The number of collected logs, including those to be removed. */
    @Volatile
    var size: Int = 0
        private set

    init {
        engine.connected { connection ->
            for (table in LakeTable.entries) {
                connection.run("CREATE TABLE ${table.table} (season INTEGER, event VARCHAR, ${table.declared})")
            }
            connection.run("CREATE TABLE $GONE (log VARCHAR)")
        }
    }

    /** Adds [entry]; [former] is the same log's former state in the lake. */
    fun add(entry: LakeEntry, former: RegisteredLog?) = lock.read {
        val partition = entry.partition
        note(entry.log, entry.records.mapValues { (_, records) -> records.map { PlacedRecord(partition, it) } })?.let(::insert)
        markChanged(listOfNotNull(partition, former?.partition), former?.files.orEmpty() - entry.files.toSet())
    }

    fun remove(former: RegisteredLog) = lock.read {
        note(former.log, emptyMap())?.let(::insert)
        markChanged(listOf(former.partition), former.files)
    }

    /** Returns the records to insert, if they justify a statement for each table; otherwise null. */
    @Synchronized
    private fun note(log: String, records: Map<LakeTable, List<PlacedRecord>>): Waiting? {
        waiting.logs += log
        for ((table, rows) in records) waiting.records.getValue(table).addAll(rows)
        size++
        if (waiting.logs.size < INSERT_BATCH) return null
        return waiting.also { waiting = Waiting() }
    }

    @Synchronized
    private fun markChanged(partitions: List<Partition>, files: List<String>) {
        changedPartitions += partitions
        obsolete += files
    }

    private fun insert(some: Waiting) = engine.connected { connection ->
        for ((table, rows) in some.records) {
            if (rows.isNotEmpty()) engine.lend(table.staged(rows)) { select -> connection.run("INSERT INTO ${table.table} $select") }
        }
        val gone = Table(listOf(RecordColumn("log", FieldType.TEXT) { some.logs[it] }), some.logs.size)
        engine.lend(gone) { select -> connection.run("INSERT INTO $GONE $select") }
    }

    /** Writes the collected records. The table of matches comes last, because the next run only knows the logs in it. */
    fun flush() = lock.write {
        if (size == 0) return@write
        insert(waiting)
        waiting = Waiting()
        engine.connected { connection ->
            for (table in LakeTable.entries) {
                for (partition in changedPartitions) rewrite(connection, table, partition)
                connection.run("TRUNCATE ${table.table}")
            }
            connection.run("TRUNCATE $GONE")
        }
        for (file in obsolete) Files.deleteIfExists(folder.resolve(file))
        changedPartitions.clear()
        obsolete.clear()
        size = 0
    }

    private fun rewrite(connection: DuckDBConnection, table: LakeTable, partition: Partition) {
        val target = LakeLayout.tableFile(folder, table.table, partition)
        val inPartition = "season IS NOT DISTINCT FROM ${partition.season ?: "NULL"} AND " +
            "event IS NOT DISTINCT FROM ${partition.event?.let(::literal) ?: "NULL"}"
        val new = "SELECT * EXCLUDE (season, event) FROM ${table.table} WHERE $inPartition"
        val all = if (!Files.exists(target)) {
            new
        } else {
            "$new UNION ALL BY NAME SELECT * FROM read_parquet(${literal("$target")}, hive_partitioning = false) " +
                "WHERE log NOT IN (SELECT log FROM $GONE)"
        }
        val rows = writeParquet(connection, "SELECT * FROM ($all) ORDER BY ${table.order}", target)
        if (rows == 0L) Files.deleteIfExists(target)
    }
}

/**
 * Writes the rows of the query [select] to [target], atomically.
 *
 * @param metadata named texts for the file's metadata.
 * @param columns the number of columns; with more of them, fewer rows are collected before they are written.
 * @return the number of rows.
 */
internal fun writeParquet(
    connection: DuckDBConnection,
    select: String,
    target: Path,
    metadata: Pair<String, String>? = null,
    columns: Int = 0,
): Long {
    Files.createDirectories(target.parent)
    val draft = target.resolveSibling("${LakeLayout.DRAFT}${UUID.randomUUID()}.part")
    try {
        val option = metadata?.let { (name, text) -> ", KV_METADATA {${literal(name)}: ${literal(text)}}" }.orEmpty()
        val group = (MAX_GROUP_CELLS / maxOf(columns, 1)).coerceIn(MIN_GROUP, MAX_GROUP)
        val rows = connection.run(
            "COPY ($select) TO ${literal("$draft")} (FORMAT parquet, COMPRESSION zstd, COMPRESSION_LEVEL 2, ROW_GROUP_SIZE $group$option)",
        )
        Files.move(draft, target, ATOMIC_MOVE, REPLACE_EXISTING)
        return rows
    } finally {
        Files.deleteIfExists(draft)
    }
}

/** The approximate number of cells of a file collected before they are written: 24 MB of numbers. */
private const val MAX_GROUP_CELLS = 3_000_000

/** The number of rows that DuckDB processes at once. */
private const val MIN_GROUP = 2_048
private const val MAX_GROUP = 122_880

private const val GONE = "gone"
private const val INSERT_BATCH = 32
