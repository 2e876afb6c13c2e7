package badlog.expression

/** One operand after joining: its sample at each of the common times. */
internal class Operand(private val samples: DoubleArray?, private val constant: Double) {
    operator fun get(index: Int): Double = if (samples == null) constant else samples[index]
}

/**
 * Several values at common times. Those of equal times stay sample by sample. Otherwise the common times are all that any of
 * them has, each once, and each value is that of its last sample until then: a gap before its first one, and where it is
 * [momentary][Column.isMomentary], [absent] at all times but its own. Where one clock was set back and another was not, what
 * the other tells of a time counts each time that it comes.
 *
 * @property x the times; null when no value is over time.
 */
internal class Joined(values: List<Value>, absent: Double) {
    /** Of those whose clock was set back. */
    val stretches: Stretches? = values.firstNotNullOfOrNull { (it as? Column)?.stretches }

    private val alike = values.map { if (it is Column && stretches != null && it.stretches == null) stretches.spread(it) else it }
    private val columns = alike.filterIsInstance<Column>()

    val x: DoubleArray? = columns.map { it.x }.reduceOrNull(::union)

    /** Whether there are events alone. */
    val isMomentary: Boolean = columns.isNotEmpty() && columns.all { it.isMomentary }

    /** The values in their order. */
    val operands: List<Operand> = alike.map {
        when (it) {
            is Scalar -> Operand(null, it.value)
            is Column -> Operand(if (isSame(it.x, x!!)) it.y else held(it, x, absent), 0.0)
        }
    }
}

private fun isSame(one: DoubleArray, other: DoubleArray) = one === other || one.contentEquals(other)

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
