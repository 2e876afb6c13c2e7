package badlog.season.engine

import org.duckdb.DuckDBColumnType
import org.duckdb.DuckDBWritableVector

/** A column of a [Table]. */
internal sealed interface Column {
    /** Its name, unique in its table regardless of case. */
    val name: String

    /** The type of the data passed to DuckDB. */
    val type: DuckDBColumnType

    /** Returns the SQL that converts this data from the column [quoted]. */
    fun sql(quoted: String): String

    /** Writes [size] cells, starting at row [from], to the start of [vector]. */
    fun write(vector: DuckDBWritableVector, from: Int, size: Int)
}

/** A column of numbers; NaN is a gap. */
internal class NumberColumn(override val name: String, private val numbers: DoubleArray) : Column {
    override val type: DuckDBColumnType get() = DuckDBColumnType.DOUBLE

    override fun sql(quoted: String): String = quoted

    override fun write(vector: DuckDBWritableVector, from: Int, size: Int) {
        for (i in 0 until size) {
            val number = numbers[from + i]
            if (number.isNaN()) vector.setNull(i.toLong()) else vector.setDouble(i.toLong(), number)
        }
    }
}

/** A column of true and false, as 1 and 0 in [numbers]; NaN is a gap. */
internal class FlagColumn(override val name: String, private val numbers: DoubleArray) : Column {
    override val type: DuckDBColumnType get() = DuckDBColumnType.BOOLEAN

    override fun sql(quoted: String): String = quoted

    override fun write(vector: DuckDBWritableVector, from: Int, size: Int) {
        for (i in 0 until size) {
            val number = numbers[from + i]
            if (number.isNaN()) vector.setNull(i.toLong()) else vector.setBoolean(i.toLong(), number != 0.0)
        }
    }
}

/** A column of texts: for each row, the result of [textOf], null for none. [textOf] is called in ascending order. */
internal class TextColumn(override val name: String, private val textOf: (Int) -> String?) : Column {
    override val type: DuckDBColumnType get() = DuckDBColumnType.VARCHAR

    override fun sql(quoted: String): String = quoted

    override fun write(vector: DuckDBWritableVector, from: Int, size: Int) {
        for (i in 0 until size) vector.setString(i.toLong(), textOf(from + i))
    }
}

/** A column of moments in UTC: [seconds] times [unit] seconds after [start], in s since 1970. */
internal class MomentColumn(
    override val name: String,
    private val start: Double,
    private val seconds: DoubleArray,
    private val unit: Double = 1.0,
) : Column {
    override val type: DuckDBColumnType get() = DuckDBColumnType.BIGINT

    override fun sql(quoted: String): String = momentSql(quoted)

    override fun write(vector: DuckDBWritableVector, from: Int, size: Int) {
        for (i in 0 until size) {
            val micros = microsOf(start + seconds[from + i] * unit)
            if (micros == null) vector.setNull(i.toLong()) else vector.setLong(i.toLong(), micros)
        }
    }
}

/** Returns the SQL that converts [micros], microseconds since 1970, to a timestamp in UTC. */
internal fun momentSql(micros: String): String = "make_timestamp($micros) AT TIME ZONE 'UTC'"

/** Returns the microseconds for [seconds] since 1970; null if that is not a time between the years 1970 and 9999. */
internal fun microsOf(seconds: Double): Long? = if (seconds >= 0 && seconds < END_OF_9999) Math.round(seconds * 1e6) else null

private const val END_OF_9999 = 2.534023008e11
