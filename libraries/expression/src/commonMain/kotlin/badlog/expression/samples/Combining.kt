package badlog.expression.samples

import kotlin.math.abs

/** Calculates with two samples. Not a function type, which would make an object of each number on the JVM. */
internal fun interface Operation {
    fun of(left: Double, right: Double): Double

    companion object {
        /** The left where the right holds. */
        val WHEN: Operation = Operation { x, on -> if (on == 1.0) x else Double.NaN }

        /** Whether both are the same; not known beside a gap. */
        val EQUAL: Operation = Operation { a, b -> known(a, b, a == b) }

        val MINUS: Operation = Operation { a, b -> a - b }

        val TIMES: Operation = Operation { a, b -> a * b }
    }
}

/** 1 where it [holds], 0 where it does not; a gap beside a gap. */
internal fun known(a: Double, b: Double, holds: Boolean): Double = if (a.isNaN() || b.isNaN()) {
    Double.NaN
} else if (holds) {
    1.0
} else {
    0.0
}

/** Calculates with each two samples of [left] and [right] at their common times; for [absent] and [isEither] see [Joined]. */
internal fun combined(left: Value, right: Value, operation: Operation, absent: Double = Double.NaN, isEither: Boolean = false): Value {
    if (left is Scalar && right is Scalar) return Scalar(operation.of(left.value, right.value), timeOf(left, right))
    val joined = Joined(listOf(left, right), absent, isEither)
    val (one, other) = joined.operands
    val x = joined.x!!
    val samples = DoubleArray(x.size) { operation.of(one[it], other[it]) }
    return Column(x, samples, null, joined.isMomentary, joined.stretches)
}

/** Where one of the two is a constant, the result is found where the other was. */
private fun timeOf(left: Scalar, right: Scalar) = when {
    left.time.isNaN() -> right.time
    right.time.isNaN() -> left.time
    else -> Double.NaN
}

/** The samples of [value] where [condition] holds, gaps elsewhere. */
internal fun restricted(value: Value, condition: Value): Value {
    val result = combined(value, condition, Operation.WHEN)
    val texts = (value as? Column)?.texts
    return if (texts == null || result !is Column) result else Column(result.x, result.y, texts, result.isMomentary, result.stretches)
}

/** [whenTrue] where [condition] holds, [whenFalse] where it does not, a gap where that is not known. */
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

/** [value], but not below [low] nor above [high]; where those cross, [high]. */
internal fun clamped(value: Value, low: Value, high: Value): Value =
    combinedThree(value, low, high, isEither = false) { sample, least, most -> minOf(maxOf(sample, least), most) }

private inline fun combinedThree(a: Value, b: Value, c: Value, isEither: Boolean, operation: (Double, Double, Double) -> Double): Value {
    if (a is Scalar && b is Scalar && c is Scalar) return Scalar(operation(a.value, b.value, c.value))
    // Between events none of them holds.
    val joined = Joined(listOf(a, b, c), absent = 0.0, isEither)
    val (first, second, third) = joined.operands
    val x = joined.x!!
    val samples = DoubleArray(x.size) { operation(first[it], second[it], third[it]) }
    return Column(x, samples, null, joined.isMomentary, joined.stretches)
}

/** True where [condition] is false. */
internal fun inverted(condition: Value): Value = combined(Scalar(1.0), condition, Operation.MINUS)

/** One operand after joining: its sample at each of the common times. */
internal class Operand(private val samples: DoubleArray?, private val constant: Double) {
    operator fun get(index: Int): Double = if (samples == null) constant else samples[index]
}

/**
 * Several values at common times. Those of equal times stay sample by sample. Otherwise the common times are all that any of
 * them has, each once, and each value is that of its last sample until then: a gap before its first one, and where it is
 * [momentary][Column.isMomentary], [absent] at all times but its own. Where one clock was set back and another was not, what
 * the other has at a time counts each time that it comes.
 *
 * What is made of moments and of what lasts is there at the moments only; if it [isEither] of them, it lasts, and each moment is over
 * as soon as it came.
 *
 * @property x the times; null when no value is over time.
 */
internal class Joined(values: List<Value>, absent: Double, isEither: Boolean) {
    /** Of those whose clock was set back. */
    val stretches: Stretches? = values.firstNotNullOfOrNull { (it as? Column)?.stretches }

    private val alike = values.map { if (it is Column && stretches != null && it.stretches == null) stretches.spread(it) else it }
    private val columns = alike.filterIsInstance<Column>()
    private val moments = columns.filter { it.isMomentary }

    /** Whether what they make is there at moments only. */
    val isMomentary: Boolean = moments.isNotEmpty() && (!isEither || moments.size == columns.size)

    val x: DoubleArray? = if (isMomentary) {
        moments.map { it.x }.reduce(::union)
    } else {
        (columns.map { it.x } + moments.map { ends(it.x) }).reduceOrNull(::union)
    }

    /** The values in their order. */
    val operands: List<Operand> = alike.map {
        when (it) {
            is Scalar -> Operand(null, it.value)
            is Column -> Operand(if (isSame(it.x, x!!)) it.y else held(it, x, absent), 0.0)
        }
    }
}

private fun isSame(one: DoubleArray, other: DoubleArray) = one === other || one.contentEquals(other)

private fun ends(moments: DoubleArray) = DoubleArray(moments.size) { moments[it] + tick(moments[it]) }

/** How long a moment at [time] is where it has to end: no time that counts. */
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
