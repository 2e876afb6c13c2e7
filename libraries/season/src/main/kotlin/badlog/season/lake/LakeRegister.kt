package badlog.season.lake

import badlog.file.LogFile
import badlog.season.engine.Engine
import badlog.season.engine.literal
import java.nio.file.Files
import java.nio.file.Path

/**
 * What a lake has of a log.
 *
 * @property log what the lake calls it.
 * @property path the log's file.
 * @property partition where its records are.
 * @property files the files of its samples, seen from the lake.
 */
internal class RegisteredLog(
    val log: String,
    val path: String,
    private val size: Long,
    private val modified: Long,
    private val maker: String,
    val partition: Partition,
    val files: List<String>,
) {
    /** Whether it is what [maker] would make of [file] as it is now. */
    fun isOf(file: LogFile, maker: String): Boolean = size == file.size && modified == file.modified && this.maker == maker
}

/** The logs that the lake [folder] has, by the paths of their files. */
internal fun registeredIn(folder: Path, engine: Engine): Map<String, RegisteredLog> {
    val files = tableFiles(folder, LakeTable.MATCHES)
    if (files.isEmpty()) return emptyMap()
    val sql = "SELECT log, path, size, epoch_ms(modified), made_by, season, event, files FROM ${scanOf(files)}"
    return engine.connected { connection ->
        connection.createStatement().use { statement ->
            statement.executeQuery(sql).use { rows ->
                val logs = LinkedHashMap<String, RegisteredLog>()
                while (rows.next()) {
                    val season = rows.getInt("season").takeUnless { rows.wasNull() }
                    val names = (rows.getArray("files").array as Array<*>).map { it as String }
                    val path = rows.getString("path")
                    logs[path] = RegisteredLog(
                        rows.getString("log"),
                        path,
                        rows.getLong("size"),
                        rows.getLong(MODIFIED),
                        rows.getString("made_by"),
                        Partition(season, rows.getString("event")),
                        names,
                    )
                }
                logs
            }
        }
    }
}

/** The files of [table] in the lake [folder], one for each partition. */
internal fun tableFiles(folder: Path, table: LakeTable): List<Path> {
    val top = folder.resolve(table.table)
    if (!Files.isDirectory(top)) return emptyList()
    return Files.walk(top, PARTITIONED).use { paths ->
        paths.filter { it.fileName.toString() == table.table + LakeLayout.ENDING }.sorted().toList()
    }
}

/** The SQL that reads [files], whose folders tell season and event. */
internal fun scanOf(files: List<Path>, isUnion: Boolean = false): String =
    "read_parquet([${files.joinToString { literal(it.toString()) }}], hive_partitioning = true, " +
        "hive_types = {'season': INTEGER, 'event': VARCHAR}${if (isUnion) ", union_by_name = true" else ""})"

private const val MODIFIED = 4

/** A folder for the season, one for the event, and a file. */
private const val PARTITIONED = 3
