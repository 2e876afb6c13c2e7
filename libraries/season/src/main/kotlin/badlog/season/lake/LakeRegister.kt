package badlog.season.lake

import badlog.season.engine.Engine
import badlog.season.engine.literal
import java.io.Serializable
import java.nio.file.Files
import java.nio.file.Path

/**
 * A log that a lake contains.
 *
 * @property log its name in the lake.
 * @property path the log's file.
 * @property files the files of its samples, relative to the lake.
 * @property isSalvaged whether data of it is lost.
 */
class RegisteredLog internal constructor(
    val log: String,
    val path: String,
    private val size: Long,
    private val modified: Long,
    private val maker: String,
    internal val partition: Partition,
    val files: List<String>,
    val isSalvaged: Boolean,
) : Serializable {
    /** The path of its partition in each table: the folders of season and event, with a slash between. */
    val partitionPath: String get() = partition.path

    /** Returns whether [source] is unchanged and [maker] the same. */
    internal fun isOf(source: LogSource, maker: String): Boolean = size == source.size && modified == source.modified && this.maker == maker
}

/** Returns the logs that the lake [folder] has. */
internal fun registeredIn(folder: Path, engine: Engine): List<RegisteredLog> {
    val files = tableFiles(folder, LakeTable.MATCHES)
    if (files.isEmpty()) return emptyList()
    val sql = "SELECT log, path, size, epoch_ms(modified), made_by, season, event, files, salvaged FROM ${scanOf(files)}"
    return engine.connected { connection ->
        connection.createStatement().use { statement ->
            statement.executeQuery(sql).use { rows ->
                val logs = ArrayList<RegisteredLog>()
                while (rows.next()) {
                    val season = rows.getInt("season").takeUnless { rows.wasNull() }
                    val names = (rows.getArray("files").array as Array<*>).map { it as String }
                    logs += RegisteredLog(
                        rows.getString("log"),
                        rows.getString("path"),
                        rows.getLong("size"),
                        rows.getLong(MODIFIED),
                        rows.getString("made_by"),
                        Partition(season, rows.getString("event")),
                        names,
                        rows.getBoolean("salvaged"),
                    )
                }
                logs
            }
        }
    }
}

/** Returns the files of [table] in the lake [folder], one for each partition. */
internal fun tableFiles(folder: Path, table: LakeTable): List<Path> {
    val top = folder.resolve(table.table)
    if (!Files.isDirectory(top)) return emptyList()
    return Files.walk(top, PARTITIONED).use { paths ->
        paths.filter { it.fileName.toString() == table.table + LakeLayout.ENDING }.sorted().toList()
    }
}

/** Returns the SQL that reads [files]; the names of their folders contain season and event. */
internal fun scanOf(files: List<Path>, isUnion: Boolean = false): String =
    "read_parquet([${files.joinToString { literal(it.toString()) }}], hive_partitioning = true, " +
        "hive_types = {'season': INTEGER, 'event': VARCHAR}${if (isUnion) ", union_by_name = true" else ""})"

private const val MODIFIED = 4

/** A folder for the season, one for the event, and a file. */
private const val PARTITIONED = 3

private const val serialVersionUID = 1L
