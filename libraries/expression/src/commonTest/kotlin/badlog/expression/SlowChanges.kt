package badlog.expression

import badlog.expression.syntax.Function

/** The functions over time: a sample for each sample, from those around it. */
internal class SlowChanges(private val noise: Noise, private val value: SlowValue) {
    private val rows = value.rows!!

    /** Null if the function is not one of these. */
    fun of(function: Function, length: Double): SlowValue? = when (function) {
        Function.WINDOW_MIN -> window(length) { it.min() }

        Function.WINDOW_MAX -> window(length) { it.max() }

        Function.WINDOW_MEAN -> windowMean(length)

        Function.DELTA -> moments { i -> if (i == 0) null else minus(rows[i], rows[i - 1]) }

        Function.DERIVATIVE -> value.with(rows.indices.map { Row(rows[it].time, slopeAt(it)) })

        Function.AREA -> value.with(rows.indices.map { i -> Row(rows[i].time, if (finiteAt(i) != null) noise.ofSum(sumUntil(i)) else null) })

        Function.PREVIOUS -> value.with(rows.indices.map { i -> Row(rows[i].time, beginOf(i).let { if (it == 0) null else rows[it - 1].value }) })

        Function.HOLD -> SlowValue(
            rows.indices.map { i -> Row(rows[i].time, (i downTo 0).firstNotNullOfOrNull { known(rows[it].value) }) },
            course = value.course,
        )

        Function.SHIFT_TIME -> value.with(rows.map { Row(it.time + length, it.value) })

        Function.CHANGED -> moments { i ->
            i > 0 && known(rows[i].value) != null && known(rows[i - 1].value) != null && !areEqual(rows[i].value!!, rows[i - 1].value!!)
        }

        else -> null
    }

    private fun finiteAt(index: Int) = finite(rows[index].value)

    private fun minus(b: Row, a: Row): Double? = number(b.value)?.let { y -> number(a.value)?.let { y - it } }

    /** The sample that holds when the window of [length] up to [index] begins. */
    private fun firstWithin(index: Int, length: Double) = (0..index).lastOrNull { rows[it].time <= rows[index].time - length + A_TICK } ?: 0

    private fun window(length: Double, fold: (List<Double>) -> Double) = value.with(
        rows.indices.map { i ->
            val inside = (firstWithin(i, length)..i).mapNotNull(::finiteAt)
            Row(rows[i].time, if (inside.isEmpty()) null else fold(inside))
        },
    )

    private fun windowMean(length: Double) = value.with(
        rows.indices.map { i ->
            val from = rows[i].time - length
            val parts = (firstWithin(i, length) until i).mapNotNull { j -> finiteAt(j)?.let { it to rows[j + 1].time - maxOf(rows[j].time, from) } }
            val weight = parts.sumOf { it.second }
            val only = parts.firstOrNull()?.first?.takeIf { one -> parts.all { it.first == one } }
            Row(rows[i].time, if (weight > 0) only ?: noise.of(parts.sumOf { it.first * it.second } / weight) else finiteAt(i))
        },
    )

    /** Whether a row is more than a repetition of the value before it. */
    private fun begins(i: Int): Boolean {
        if (i == 0 || value.isMomentary) return true
        val a = known(rows[i].value)
        val b = known(rows[i - 1].value)
        return if (a == null || b == null) (a == null) != (b == null) else !areEqual(a, b)
    }

    private fun beginOf(i: Int) = (i downTo 0).first(::begins)

    private fun moments(sample: (Int) -> Any?) = value.moments(rows.indices.filter(::begins).map { Row(rows[it].time, sample(it)) })

    private fun isSetBack(a: Row, b: Row) = value.course != null && value.course.stretchOf(a.time) != value.course.stretchOf(b.time)

    private fun slopeAt(i: Int): Double? {
        val from = rows[beginOf(i)]
        val to = (i + 1 until rows.size).firstOrNull(::begins)?.let { rows[it] } ?: return finite(from.value)?.let { 0.0 }
        return if (to.time > from.time && !isSetBack(from, to)) minus(to, from)?.let { it / (to.time - from.time) } else null
    }

    private fun sumUntil(last: Int): Double = (1..last).sumOf { i -> (finiteAt(i - 1) ?: 0.0) * (rows[i].time - rows[i - 1].time) }
}
