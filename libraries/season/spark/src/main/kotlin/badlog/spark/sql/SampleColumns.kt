package badlog.spark.sql

import org.apache.spark.sql.SparkSession

/**
 * The columns of all files of samples, known by the table of topics.
 *
 * @param types of each column its type; of those that differ from log to log, one that all of them fit into.
 * @property mixed the columns that differ so, with that type.
 */
internal class SampleColumns private constructor(private val types: Map<String, String>, val mixed: Map<String, String>) {
    /** Files whose columns have the same types: [types] has those of the columns that are mixed. */
    class Kind(val files: List<String>, val types: Map<String, String>)

    /** Returns what to read the files as: of a column whose name [typeOf] changes into a type, that type. */
    fun schema(typeOf: (String) -> String): String = FIXED + types.entries.joinToString("") { (name, type) ->
        ", ${quoted(name)} ${typeOf(name).takeIf { it != name } ?: type}"
    }

    /** All files of samples, by the types of their [mixed] columns. */
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
        /** Those of the lake whose table of topics [spark] has. */
        fun of(spark: SparkSession): SampleColumns {
            val found = spark.sql(
                "SELECT min(column_name), collect_set($TYPE) FROM topics " +
                    "WHERE stored = 'samples' AND lower(column_name) NOT IN ('t') GROUP BY lower(column_name) ORDER BY 1",
            ).collectAsList().associate { row -> row.getString(0) to row.getList<String>(1).toSet() }
            val types = found.mapValues { (_, types) -> types.singleOrNull() ?: if ("STRING" in types) "STRING" else "DOUBLE" }
            return SampleColumns(types, types.filterKeys { found.getValue(it).size > 1 })
        }

        private const val FIXED = "log STRING, type STRING, number INT, t DOUBLE, timestamp TIMESTAMP"

        /** What a column holds, by what the table of topics says of it; as the layout of lakes has it. */
        private const val TYPE =
            "CASE WHEN kind IN ('state', 'event') OR array_contains(attributes, 'log') THEN 'STRING' " +
                "WHEN kind = 'boolean' THEN 'BOOLEAN' ELSE 'DOUBLE' END"
    }
}
