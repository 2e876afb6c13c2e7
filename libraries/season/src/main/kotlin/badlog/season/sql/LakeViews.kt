package badlog.season.sql

import badlog.core.text.freeName
import badlog.season.engine.literal
import badlog.season.engine.quoted
import badlog.season.engine.run
import badlog.season.lake.LakeTable
import badlog.season.lake.scanOf
import badlog.season.lake.tableFiles
import org.duckdb.DuckDBConnection
import java.nio.file.Path

/**
 * The views that queries of the lake [folder] can use. A view is created when a query first mentions it, since views of thousands
 * of files take time.
 *
 * @param hidden columns of the table of matches that queries do not see.
 */
internal class LakeViews(
    private val folder: Path,
    private val connection: DuckDBConnection,
    private val hidden: Set<String> = emptySet(),
) {
    private val made = HashSet<LakeView>()

    /** Creates the views that [sql] mentions. */
    fun makeFor(sql: String) {
        val listsTables = LISTS_TABLES.containsMatchIn(sql)
        for (view in LakeView.entries) if (listsTables || sql.contains(view.sqlName, ignoreCase = true)) make(view)
    }

    /** Creates [view], if it does not exist yet. */
    fun make(view: LakeView) {
        if (!made.add(view)) return
        val select = when (view) {
            LakeView.SAMPLES -> samples("samples")
            LakeView.SERIES -> samples("series")
            LakeView.MATCH_STATISTICS -> matchStatistics()
            else -> table(LakeTable.valueOf(view.name))
        }
        connection.run("CREATE VIEW ${view.sqlName} AS $select")
    }

    private fun table(table: LakeTable): String {
        val files = tableFiles(folder, table)
        val columns = if (table == LakeTable.MATCHES && hidden.isNotEmpty()) "* EXCLUDE (${hidden.joinToString { quoted(it) }})" else "*"
        if (files.isEmpty()) return "SELECT $columns FROM (SELECT ${nullColumns(table)}) WHERE false"
        return "SELECT $columns FROM ${scanOf(files)}"
    }

    private fun nullColumns(table: LakeTable) = table.fields.joinToString { (name, type) -> "NULL::${type.type} AS ${quoted(name)}" } +
        ", NULL::INTEGER AS season, NULL::VARCHAR AS event"

    /** Returns the files of [kind] that are listed in the table of matches, which excludes leftovers of an interrupted run. */
    private fun samples(kind: String): String {
        make(LakeView.MATCHES)
        val files = texts("SELECT unnest(files) AS file FROM matches ORDER BY file").filter { it.startsWith("$kind/") }.map(folder::resolve)
        if (files.isEmpty()) return NO_SAMPLES
        return "SELECT * FROM ${scanOf(files, isUnion = true)}"
    }

    /** Returns one column per topic, a struct of its statistics. */
    private fun matchStatistics(): String {
        make(LakeView.MATCHES)
        make(LakeView.STATISTICS)
        val taken = LakeTable.MATCHES.fields.mapTo(hashSetOf("season", "event")) { it.first }
        val topics = texts("SELECT DISTINCT topic FROM statistics ORDER BY topic")
        if (topics.isEmpty()) return "SELECT * FROM matches"
        val columns = topics.joinToString { topic ->
            "any_value($FIELDS) FILTER (WHERE topic = ${literal(topic)}) AS ${quoted(freeName(topic) { taken.add(it.lowercase()) })}"
        }
        return "SELECT * FROM matches LEFT JOIN (SELECT log, $columns FROM statistics GROUP BY log) USING (log)"
    }

    private fun texts(sql: String): List<String> = connection.createStatement().use { statement ->
        statement.executeQuery(sql).use { rows -> buildList { while (rows.next()) add(rows.getString(1)) } }
    }

    private companion object {
        val LISTS_TABLES = Regex("\\b(show|information_schema|duckdb_\\w+)\\b", RegexOption.IGNORE_CASE)
        const val FIELDS =
            "{'unit': unit, 'count': count, 'min': min, 'max': max, 'mean': mean, 'median': median, 'p5': p5, 'p95': p95, " +
                "'first': first, 'last': last}"
        const val NO_SAMPLES =
            "SELECT * FROM (SELECT NULL::VARCHAR AS log, NULL::DOUBLE AS t, NULL::INTEGER AS season, NULL::VARCHAR AS event) " +
                "WHERE false"
    }
}

/**
 * A view that queries can use.
 *
 * @property meaning the meaning of a row, as a sentence without its period.
 */
internal enum class LakeView(val meaning: String) {
    MATCHES("a row per log: which match, when, its header values, its problems"),
    TOPICS("a row per log and topic: unit, attributes, kind, rate, range"),
    STATISTICS("a row per log and topic that has numbers: count, min, max, mean and percentiles by time"),
    MATCH_STATISTICS("a row per log: the columns of matches, and a column per topic with its statistics: \"System/Battery Voltage\".min"),
    SAMPLES("a row per row of each log that has rows, such as a bag, with a column per topic"),
    SERIES("a row per sample of the topics that have times of their own, such as those of WPILOGs: topic, t, value, text"),
    EVENTS("a row per text with a time"),
    FINDINGS("a row per finding of the rules"),
    ;

    /** Its name in SQL. */
    val sqlName: String get() = name.lowercase()
}
