package badlog.expression.samples

import kotlin.math.abs

/** A calculation with two samples. It is not a function type, which would box each number on the JVM. */
internal fun interface Operation {
    fun of(left: Double, right: Double): Double

    companion object {
        /** The left sample where the right one holds, otherwise a gap. */
        val WHEN: Operation = Operation { x, on -> if (on == 1.0) x else Double.NaN }

        /** Whether both are equal; unknown if one is a gap. */
        val EQUAL: Operation = Operation { a, b -> known(a, b, a == b) }

        val MINUS: Operation = Operation { a, b -> a - b }

        val TIMES: Operation = Operation { a, b -> a * b }
    }
}

/** Returns 1 if [holds], otherwise 0; a gap if one of the samples is a gap. */
internal fun known(a: Double, b: Double, holds: Boolean): Double = if (a.isNaN() || b.isNaN()) {
    Double.NaN
} else if (holds) {
    1.0
} else {
    0.0
}

/** Applies [operation] to [left] and [right] at their common times; for [absent] and [isEither] see [Joined]. */
internal fun combined(left: Value, right: Value, operation: Operation, absent: Double = Double.NaN, isEither: Boolean = false): Value {
    if (left is Scalar && right is Scalar) return Scalar(operation.of(left.value, right.value), timeOf(left, right))
    val joined = Joined(listOf(left, right), absent, isEither)
    val (one, other) = joined.operands
    val x = joined.x!!
    val samples = DoubleArray(x.size) { operation.of(one[it], other[it]) }
    return Column(x, samples, null, joined.isMomentary, joined.stretches)
}

/** If one of the two has no time, the result has the time of the other. */
private fun timeOf(left: Scalar, right: Scalar) = when {
    left.time.isNaN() -> right.time
    right.time.isNaN() -> left.time
    else -> Double.NaN
}

/** Returns the samples of [value] where [condition] holds, and gaps elsewhere. */
internal fun restricted(value: Value, condition: Value): Value {
    val result = combined(value, condition, Operation.WHEN)
    val texts = (value as? Column)?.texts
    return if (texts == null || result !is Column) result else Column(result.x, result.y, texts, result.isMomentary, result.stretches)
}

/** Returns [whenTrue] where [condition] holds, [whenFalse] where it does not, and a gap where that is not known. */
internal fun chosen(condition: Value, whenTrue: Value, whenFalse: Value): Value =
    combinedThree(condition, whenTrue, whenFalse, isEither = true) { on, yes, no ->
        if (on == 1.0) {
            yes
        } else if (on == 0.0) {
            no
        } else {
            Double.NaN
        }
    }

/** Returns [value] limited to the range from [low] to [high]. Where [low] is above [high], returns [high]. */
internal fun clamped(value: Value, low: Value, high: Value): Value =
    combinedThree(value, low, high, isEither = false) { sample, least, most -> minOf(maxOf(sample, least), most) }

private inline fun combinedThree(a: Value, b: Value, c: Value, isEither: Boolean, operation: (Double, Double, Double) -> Double): Value {
    if (a is Scalar && b is Scalar && c is Scalar) return Scalar(operation(a.value, b.value, c.value))
    // Between events, none of them holds.
    val joined = Joined(listOf(a, b, c), absent = 0.0, isEither)
    val (first, second, third) = joined.operands
    val x = joined.x!!
    val samples = DoubleArray(x.size) { operation(first[it], second[it], third[it]) }
    return Column(x, samples, null, joined.isMomentary, joined.stretches)
}

/** Returns a condition that is true where [condition] is false. */
internal fun inverted(condition: Value): Value = combined(Scalar(1.0), condition, Operation.MINUS)

/** One operand after joining: its sample at each of the common times. */
internal class Operand(private val samples: DoubleArray?, private val constant: Double) {
    operator fun get(index: Int): Double = if (samples == null) constant else samples[index]
}

/**
 * Several values at common times. Values with equal times are combined sample by sample. Otherwise the common times are the times of all
 * values, each once. At each of them, a value has its last sample up to then, and a gap before its first one. A
 * [momentary][Column.isMomentary] value is [absent] at all times but its own. If only some clocks were set back, the samples on the others
 * count each time that their time occurs.
 *
 * A combination of moments and lasting values exists only at the moments; with [isEither], it lasts, and each moment is over at once.
 *
 * @property x the times; null if no value is over time.
 */
internal class Joined(values: List<Value>, absent: Double, isEither: Boolean) {
    /** The stretches of a clock that was set back; null if there is none. */
    val stretches: Stretches? = values.firstNotNullOfOrNull { (it as? Column)?.stretches }

    private val onCommonClock = values.map { if (it is Column && stretches != null && it.stretches == null) stretches.spread(it) else it }
    private val columns = onCommonClock.filterIsInstance<Column>()
    private val moments = columns.filter { it.isMomentary }

    /** Whether their combination exists only at moments. */
    val isMomentary: Boolean = moments.isNotEmpty() && (!isEither || moments.size == columns.size)

    val x: DoubleArray? = if (isMomentary) {
        moments.map { it.x }.reduce(::union)
    } else {
        (columns.map { it.x } + moments.map { ends(it.x) }).reduceOrNull(::union)
    }

    /** The values, in order. */
    val operands: List<Operand> = onCommonClock.map {
        when (it) {
            is Scalar -> Operand(null, it.value)
            is Column -> Operand(if (isSame(it.x, x!!)) it.y else held(it, x, absent), 0.0)
        }
    }
}

private fun isSame(one: DoubleArray, other: DoubleArray) = one === other || one.contentEquals(other)

private fun ends(moments: DoubleArray) = DoubleArray(moments.size) { moments[it] + tick(moments[it]) }

/** Returns a negligibly short duration for a moment at [time], for calculations that need its end. */
internal fun tick(time: Double): Double = maxOf(1.0, abs(time)) * 1e-14

private fun union(one: DoubleArray, other: DoubleArray): DoubleArray {
    if (isSame(one, other)) return one
    val times = DoubleArray(one.size + other.size)
    var size = 0
    var i = 0
    var j = 0
    while (i < one.size || j < other.size) {
        val time = if (j == other.size || (i < one.size && one[i] <= other[j])) one[i++] else other[j++]
        if (size == 0 || times[size - 1] != time) times[size++] = time
    }
    return times.copyOf(size)
}

private fun held(column: Column, times: DoubleArray, absent: Double): DoubleArray {
    val x = column.x
    var next = 0
    return DoubleArray(times.size) { index ->
        val time = times[index]
        while (next < x.size && x[next] <= time) next++
        when {
            column.isMomentary && (next == 0 || x[next - 1] != time) -> absent
            next == 0 -> Double.NaN
            else -> column.y[next - 1]
        }
    }
}
