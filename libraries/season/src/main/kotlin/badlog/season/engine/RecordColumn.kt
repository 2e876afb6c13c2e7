package badlog.season.engine

import org.duckdb.DuckDBColumnType
import org.duckdb.DuckDBWritableVector

/**
 * The type of a field of records: each value is null, or as documented.
 *
 * @property given the type of the data passed to DuckDB.
 * @property type the resulting SQL type.
 */
internal enum class FieldType(val given: DuckDBColumnType, val type: String) {
    /** A [String]. */
    TEXT(DuckDBColumnType.VARCHAR, "VARCHAR"),

    /** A [Double]; NaN is null. */
    NUMBER(DuckDBColumnType.DOUBLE, "DOUBLE"),

    /** A [Long]. */
    COUNT(DuckDBColumnType.BIGINT, "BIGINT"),

    /** An [Int]. */
    WHOLE(DuckDBColumnType.INTEGER, "INTEGER"),

    /** A [Boolean]. */
    FLAG(DuckDBColumnType.BOOLEAN, "BOOLEAN"),

    /** A [Long], the microseconds since 1970, which becomes a timestamp in UTC. */
    MOMENT(DuckDBColumnType.BIGINT, "TIMESTAMP WITH TIME ZONE"),

    /** The JSON of a list of texts. */
    TEXTS(DuckDBColumnType.VARCHAR, "VARCHAR[]"),

    /** A JSON object with text values, which becomes a map from names to texts. */
    TEXT_OF_NAME(DuckDBColumnType.VARCHAR, "MAP(VARCHAR, VARCHAR)"),

    /** The JSON of a list of spans. */
    SPANS(DuckDBColumnType.VARCHAR, "STRUCT(\"from\" DOUBLE, \"to\" DOUBLE)[]"),

    /** The JSON of a list of problems. */
    PROBLEMS(
        DuckDBColumnType.VARCHAR,
        "STRUCT(severity VARCHAR, message VARCHAR, line INTEGER, topic VARCHAR, count INTEGER)[]",
    ),
    ;

    /** Returns whether a field of this type can hold [value]. */
    fun fits(value: Any?): Boolean = value == null || when (given) {
        DuckDBColumnType.DOUBLE -> value is Double
        DuckDBColumnType.BIGINT -> value is Long
        DuckDBColumnType.INTEGER -> value is Int
        DuckDBColumnType.BOOLEAN -> value is Boolean
        else -> value is String
    }
}

/** The column of one field of records, with values of a [FieldType]; [valueOf] returns the value for a row. */
internal class RecordColumn(override val name: String, private val kind: FieldType, private val valueOf: (Int) -> Any?) : Column {
    override val type: DuckDBColumnType get() = kind.given

    override fun sql(quoted: String): String = when (kind) {
        FieldType.MOMENT -> momentSql(quoted)
        FieldType.TEXTS, FieldType.TEXT_OF_NAME, FieldType.SPANS, FieldType.PROBLEMS -> "($quoted::JSON)::${kind.type}"
        else -> quoted
    }

    override fun write(vector: DuckDBWritableVector, from: Int, size: Int) {
        for (i in 0 until size) put(vector, i.toLong(), valueOf(from + i))
    }

    private fun put(vector: DuckDBWritableVector, at: Long, value: Any?) {
        if (value == null || (value is Double && value.isNaN())) return vector.setNull(at)
        when (kind.given) {
            DuckDBColumnType.DOUBLE -> vector.setDouble(at, value as Double)
            DuckDBColumnType.BIGINT -> vector.setLong(at, value as Long)
            DuckDBColumnType.INTEGER -> vector.setInt(at, value as Int)
            DuckDBColumnType.BOOLEAN -> vector.setBoolean(at, value as Boolean)
            else -> vector.setString(at, value as String)
        }
    }
}
