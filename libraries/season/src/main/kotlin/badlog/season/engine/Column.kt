package badlog.season.engine

import org.duckdb.DuckDBColumnType
import org.duckdb.DuckDBWritableVector

/** A column of a [Table]. */
internal sealed interface Column {
    /** What it is called; no two columns of a table have names that differ in the case of letters alone, if at all. */
    val name: String

    /** What DuckDB is given. */
    val type: DuckDBColumnType

    /** What becomes of that, as SQL, where it is called [quoted]. */
    fun sql(quoted: String): String

    /** Writes [size] cells, from that of row [from] on, into [vector], from its beginning on. */
    fun write(vector: DuckDBWritableVector, from: Int, size: Int)
}

/** Numbers, of which NaN is a gap. */
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

/** True and false, which are 1 and 0 in [numbers]; NaN is a gap. */
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

/** Texts: of each row what [textOf] says, null for none. It is asked in ascending order. */
internal class TextColumn(override val name: String, private val textOf: (Int) -> String?) : Column {
    override val type: DuckDBColumnType get() = DuckDBColumnType.VARCHAR

    override fun sql(quoted: String): String = quoted

    override fun write(vector: DuckDBWritableVector, from: Int, size: Int) {
        for (i in 0 until size) vector.setString(i.toLong(), textOf(from + i))
    }
}

/** Moments in UTC: so many seconds of [seconds], each [unit] seconds long, after [start], in s since 1970. */
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

/** The SQL that makes a time with UTC of the microseconds since 1970 that [micros] is. */
internal fun momentSql(micros: String): String = "make_timestamp($micros) AT TIME ZONE 'UTC'"

/** The microseconds of [seconds] since 1970; null where that is not a time between the years 1970 and 9999. */
internal fun microsOf(seconds: Double): Long? = if (seconds >= 0 && seconds < END_OF_9999) Math.round(seconds * 1e6) else null

private const val END_OF_9999 = 2.534023008e11
