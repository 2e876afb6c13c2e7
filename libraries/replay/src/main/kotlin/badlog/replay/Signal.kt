package badlog.replay

import badlog.analysis.Series
import badlog.analysis.Units

/**
 * What is shown as one topic of NetworkTables.
 *
 * @property name its whole name there; begins with `/`.
 * @property unit its unit, or null for none.
 * @property samples its values; ordered, and without gaps but for a [SignalType.DOUBLE], of which NaN says that there is
 *   no number from then on.
 * @property texts what the samples of a [SignalType.STRING] stand for, in UTF-8; else empty.
 * @property typeName what its announcement calls the type.
 * @property payload gives the bytes of a sample, as a WPILOG has them, where these count and not the samples' numbers; else null.
 */
internal class Signal(
    val name: String,
    val type: SignalType,
    unit: String,
    val samples: Series,
    val texts: List<ByteArray> = emptyList(),
    val typeName: String = type.typeName,
    val payload: ((index: Int) -> ByteArray)? = null,
) {
    val unit: String? = unit.takeUnless(Units::isNone)

    /** How many samples stand at or before [position]. */
    fun countUntil(position: Double): Int = samples.firstAtOrAfter(Math.nextUp(position))
}

/**
 * What kind of value a topic of NetworkTables has.
 *
 * @property typeName what an announcement calls it.
 * @property code what a value's message calls it.
 */
internal enum class SignalType(val typeName: String, val code: Int) {
    BOOLEAN("boolean", 0),
    DOUBLE("double", 1),
    INT("int", 2),
    FLOAT("float", 3),
    STRING("string", 4),

    /** Bytes, whatever the topic says they are. */
    RAW("raw", 5),
    BOOLEANS("boolean[]", 16),
    DOUBLES("double[]", 17),
    INTS("int[]", 18),
    FLOATS("float[]", 19),
    STRINGS("string[]", 20),
    ;

    companion object {
        /** What values of a WPILOG's type [name] are here. */
        fun of(name: String): SignalType = when (name) {
            "int64" -> INT
            "int64[]" -> INTS
            "json" -> STRING
            else -> entries.find { it.typeName == name } ?: RAW
        }
    }
}

/** These samples in the order of x; those of one x keep their order. */
internal fun Series.ordered(): Series {
    if (isOrdered) return this
    val order = (0 until size).sortedBy { x[it] }
    return Series(DoubleArray(size) { x[order[it]] }, DoubleArray(size) { y[order[it]] })
}

/** These samples with at most the first of each gap's, and not even that when [keepsFirst] is false or nothing was before. */
internal fun Series.withoutGaps(keepsFirst: Boolean): Series {
    fun isKept(i: Int) = !y[i].isNaN() || (keepsFirst && i > 0 && !y[i - 1].isNaN())
    val kept = (0 until size).count(::isKept)
    if (kept == size) return this
    val keptX = DoubleArray(kept)
    val keptY = DoubleArray(kept)
    var at = 0
    for (i in 0 until size) {
        if (!isKept(i)) continue
        keptX[at] = x[i]
        keptY[at++] = y[i]
    }
    return Series(keptX, keptY)
}
