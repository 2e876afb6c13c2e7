package badlog.spark.sql

import org.apache.spark.sql.SparkSession

/**
 * The columns of all files of samples, according to the table of topics.
 *
 * @param types the type of each column; for a column with different types in different logs, one that holds all of them.
 * @property mixed the columns with different types in different logs, with that common type.
 */
internal class SampleColumns private constructor(private val types: Map<String, String>, val mixed: Map<String, String>) {
    /** Files with the same column types; [types] holds the types of the mixed columns. */
    class Kind(val files: List<String>, val types: Map<String, String>)

    /**
     * Returns the schema for reading the files. [typeOf] returns a column's type; if it returns the name unchanged, the common type is
     * used.
     */
    fun schema(typeOf: (String) -> String): String = FIXED + types.entries.joinToString("") { (name, type) ->
        ", ${quoted(name)} ${typeOf(name).takeIf { it != name } ?: type}"
    }

    /** Returns all files of samples, grouped by the types of their [mixed] columns. */
    fun kinds(spark: SparkSession): List<Kind> {
        val names = mixed.keys.joinToString { literal(it.lowercase()) }
        val rows = spark.sql(
            """
            SELECT collect_list(file) AS files, types FROM (
                SELECT log, sort_array(collect_list(named_struct('name', lower(column_name), 'type', $TYPE))
                    FILTER (WHERE lower(column_name) IN ($names))) AS types
                FROM topics WHERE stored = 'samples' GROUP BY log
            ) JOIN (SELECT log, explode(files) AS file FROM matches) USING (log)
            WHERE file LIKE 'samples/%' GROUP BY types
            """.trimIndent(),
        ).collectAsList()
        val nameOf = mixed.keys.associateBy { it.lowercase() }
        return rows.map { row ->
            val types = row.getList<org.apache.spark.sql.Row>(1).associate { nameOf.getValue(it.getString(0)) to it.getString(1) }
            Kind(row.getList(0), types)
        }
    }

    companion object {
        /** Returns the columns according to the table of topics in [spark]. */
        fun of(spark: SparkSession): SampleColumns {
            val found = spark.sql(
                "SELECT min(column_name), collect_set($TYPE) FROM topics " +
                    "WHERE stored = 'samples' AND lower(column_name) NOT IN ('t') GROUP BY lower(column_name) ORDER BY 1",
            ).collectAsList().associate { row -> row.getString(0) to row.getList<String>(1).toSet() }
            val types = found.mapValues { (_, types) -> types.singleOrNull() ?: if ("STRING" in types) "STRING" else "DOUBLE" }
            return SampleColumns(types, types.filterKeys { found.getValue(it).size > 1 })
        }

        private const val FIXED = "log STRING, type STRING, number INT, t DOUBLE, timestamp TIMESTAMP"

        /** The type of a column, calculated from its row in the table of topics as the layout of lakes prescribes. */
        private const val TYPE =
            "CASE WHEN kind IN ('state', 'event') OR array_contains(attributes, 'log') THEN 'STRING' " +
                "WHEN kind = 'boolean' THEN 'BOOLEAN' ELSE 'DOUBLE' END"
    }
}
