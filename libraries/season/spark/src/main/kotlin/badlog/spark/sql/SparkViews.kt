package badlog.spark.sql

import badlog.core.text.freeName
import badlog.season.lake.LakeLayout
import badlog.spark.storage.RemoteFolder
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.functions.col
import org.apache.spark.sql.functions.expr
import org.apache.spark.sql.types.StructType

/**
 * The views for queries of a lake, with the same names as in `badlog sql`. A view is created when a query first mentions it. Views of
 * samples get their columns from the table of topics, so that no file is opened to learn its columns.
 *
 * @param address the address of the lake's folder.
 */
internal class SparkViews(private val spark: SparkSession, private val address: String, private val lake: RemoteFolder) {
    private val made = HashSet<String>()

    init {
        // Seasons are numbers; events are texts, even those that look like numbers.
        spark.conf().set("spark.sql.sources.partitionColumnTypeInference.enabled", false)
        // Names of topics have the same quotes as in `badlog sql`.
        spark.conf().set("spark.sql.ansi.enabled", true)
        spark.conf().set("spark.sql.ansi.doubleQuotedIdentifiers", true)
        spark.conf().set("spark.sql.session.timeZone", "UTC")
    }

    /** Creates the views that [sql] mentions. */
    fun makeFor(sql: String) {
        for (view in LakeLayout.TABLES + LakeLayout.SAMPLES + LakeLayout.SERIES + STATISTICS) {
            if (sql.contains(view, ignoreCase = true)) make(view)
        }
    }

    private fun make(view: String) {
        if (!made.add(view)) return
        val rows = when (view) {
            LakeLayout.SAMPLES -> samples()
            LakeLayout.SERIES -> read(view, SERIES)
            STATISTICS -> matchStatistics()
            else -> read(view, schemaOf(view))
        }
        rows.createOrReplaceTempView(view)
    }

    private fun read(table: String, columns: String): Dataset<Row> {
        val schema = StructType.fromDDL("$columns, $PLACE")
        val isThere = lake.has(table)
        return placed(
            if (isThere) spark.read().schema(schema).parquet("$address/$table") else spark.createDataFrame(emptyList<Row>(), schema),
        )
    }

    /** Decodes the columns of the partition: Spark treats each byte of a percent-encoded name as a character. */
    private fun placed(rows: Dataset<Row>): Dataset<Row> = rows
        .withColumn("season", col("season").cast("int"))
        .withColumn("event", expr("decode(encode(event, 'ISO-8859-1'), 'UTF-8')"))

    private fun samples(): Dataset<Row> {
        make("topics")
        val columns = SampleColumns.of(spark)
        if (columns.mixed.isEmpty()) return read(LakeLayout.SAMPLES, columns.schema { it })
        make(LakeLayout.MATCHES)
        return columns.kinds(spark).map { kind ->
            val files = kind.files.map { "$address/$it" }
            val rows = spark.read().schema(
                "${columns.schema {
                    kind.types[it] ?: it
                }}, $PLACE",
            ).option("basePath", "$address/${LakeLayout.SAMPLES}")
                .parquet(*files.toTypedArray())
            placed(columns.mixed.entries.fold(rows) { all, (name, type) -> all.withColumn(name, col(quoted(name)).cast(type)) })
        }.reduce(Dataset<Row>::unionByName)
    }

    /** Returns one column per topic, a struct of its statistics. */
    private fun matchStatistics(): Dataset<Row> {
        make(LakeLayout.MATCHES)
        make("statistics")
        val topics = spark.sql("SELECT DISTINCT topic FROM statistics ORDER BY topic").collectAsList().map { it.getString(0) }
        val taken = spark.table(LakeLayout.MATCHES).columns().mapTo(HashSet()) { it.lowercase() }
        val columns = topics.joinToString { topic ->
            "any_value($FIELDS) FILTER (WHERE topic = ${literal(topic)}) AS ${quoted(freeName(topic) { taken.add(it.lowercase()) })}"
        }
        return spark.sql("SELECT * FROM matches LEFT JOIN (SELECT log, $columns FROM statistics GROUP BY log) USING (log)")
    }

    private companion object {
        const val STATISTICS = "match_statistics"
        const val PLACE = "season STRING, event STRING"
        const val SERIES =
            "log STRING, type STRING, number INT, topic STRING, t DOUBLE, timestamp TIMESTAMP, value DOUBLE, text STRING"
        const val FIELDS =
            "named_struct('unit', unit, 'count', count, 'min', min, 'max', max, 'mean', mean, 'median', median, 'p5', p5, 'p95', p95, " +
                "'first', first, 'last', last)"
    }
}

/** Returns the columns of a table of all logs as Spark declares them. They are known, so that no file is opened. */
private fun schemaOf(table: String): String =
    LakeLayout.columnsOf(table).joinToString { (name, type) -> "${quoted(name)} ${sparkType(type)}" }

/** Returns Spark's name for DuckDB's type [type]. */
private fun sparkType(type: String): String = when {
    type.endsWith("[]") -> "ARRAY<${sparkType(type.removeSuffix("[]"))}>"

    type.startsWith("STRUCT(") -> type.removeSurrounding("STRUCT(", ")").split(", ")
        .joinToString(prefix = "STRUCT<", postfix = ">") { field ->
            quoted(field.substringBefore(' ').removeSurrounding("\"")) + ": " + sparkType(field.substringAfter(' '))
        }

    type.startsWith(
        "MAP(",
    ) -> type.removeSurrounding("MAP(", ")").split(", ").joinToString(prefix = "MAP<", postfix = ">", transform = ::sparkType)

    type == "VARCHAR" -> "STRING"

    type == "TIMESTAMP WITH TIME ZONE" -> "TIMESTAMP"

    else -> type
}

/** Returns [name] as a quoted name in Spark's SQL; backticks in it are doubled. */
internal fun quoted(name: String): String = "`${name.replace("`", "``")}`"

/** Returns [text] as a literal of Spark's SQL. */
internal fun literal(text: String): String = "'${text.replace("\\", "\\\\").replace("'", "\\'")}'"
