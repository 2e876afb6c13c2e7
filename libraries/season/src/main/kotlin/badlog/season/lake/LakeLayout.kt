package badlog.season.lake

import java.io.Serializable
import java.nio.file.Path
import java.util.zip.CRC32

/** The layout of a lake; `docs/season.md` specifies it. */
object LakeLayout {
    /** The version of the layout. Increase it if a reader of the previous layout would misunderstand the new one. */
    internal const val VERSION = 1

    /** The file that marks a folder as a lake, with its version. */
    const val MARK: String = "lake.json"

    /** The lock file, which only one program can have open. */
    internal const val LOCK = ".lock"

    /** The folder of the files with a row for each row of a log. */
    const val SAMPLES: String = "samples"

    /** The folder of the files with the samples of topics that have times of their own. */
    const val SERIES: String = "series"

    /** The beginning of the names of unfinished files, which readers ignore. */
    const val DRAFT: String = ".badlog-"

    /** The ending of the names of all files of tables. */
    const val ENDING: String = ".parquet"

    /** The folders of the tables that have records of many logs, in the order in which they are written. */
    val TABLES: List<String> = LakeTable.entries.map { it.table }

    /** Returns the columns of [table], one of [TABLES], with DuckDB's names of their types. */
    fun columnsOf(table: String): List<Pair<String, String>> =
        LakeTable.entries.first { it.table == table }.fields.map { (name, type) -> name to type.type }

    /** The folder of the table that lists the logs of a lake. */
    val MATCHES: String = LakeTable.MATCHES.table

    /** Returns the path of the table [name] of [partition] in the lake [folder]. */
    internal fun tableFile(folder: Path, name: String, partition: Partition): Path =
        folder.resolve(name).resolve(partition.path).resolve(name + ENDING)

    /** Returns the path, with slashes, of the file of [kind] for the log [log] in a lake. */
    internal fun logFile(kind: String, partition: Partition, log: String): String {
        val name = encoded(log)
        val short = if (name.length <= MAX_NAME) {
            name
        } else {
            name.take(MAX_NAME) + "-" + CRC32().apply { update(log.encodeToByteArray()) }.value
        }
        return "$kind/${partition.path}/$short$ENDING"
    }

    /**
     * Returns [text] as a file name. All characters but ASCII letters, digits, hyphens, periods and underscores are percent-encoded, and so
     * is a period or underscore at the beginning.
     */
    internal fun encoded(text: String): String = buildString {
        for ((i, byte) in text.encodeToByteArray().withIndex()) {
            val char = (byte.toInt() and BYTE).toChar()
            // Readers skip names that begin like this.
            val isPlain = char in 'a'..'z' || char in 'A'..'Z' || char in '0'..'9' || char == '-' || (char in "._" && i > 0)
            if (isPlain) append(char) else append('%').append((byte.toInt() and BYTE).toString(HEX).uppercase().padStart(2, '0'))
        }
    }

    private const val MAX_NAME = 160
    private const val BYTE = 0xFF
    private const val HEX = 16
}

/**
 * A part of a lake. Engines can skip it in queries about another part.
 *
 * @property season the year; null if unknown.
 * @property event the event; null if unknown.
 */
internal data class Partition(val season: Int?, val event: String?) : Serializable {
    /** Its folder, in Hive's notation. */
    val path: String get() = "season=${season ?: UNKNOWN}/event=${event?.let(LakeLayout::encoded) ?: UNKNOWN}"
}

private const val serialVersionUID = 1L

/** The name for null in all engines. */
private const val UNKNOWN = "__HIVE_DEFAULT_PARTITION__"
