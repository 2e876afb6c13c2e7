package badlog.expression

/** A sample: a number, a condition, a text or, for a gap, null. */
internal data class Row(val time: Double, val value: Any?)

/** The value of a part of an expression. It is [rows] over time, with a [course] if their clock was set back, or [single]. */
internal class SlowValue(
    val rows: List<Row>?,
    val single: Any? = null,
    val isMomentary: Boolean = false,
    val course: SlowCourse? = null,
) {
    fun at(time: Double, absent: Any?): Any? {
        if (rows == null) return single
        val row = rows.lastOrNull { it.time <= time }
        return if (isMomentary && row?.time != time) absent else row?.value
    }

    /** Other samples of the same kind. */
    fun with(rows: List<Row>) = SlowValue(rows, isMomentary = isMomentary, course = course)

    /** Moments of the same clock. */
    fun moments(rows: List<Row>) = SlowValue(rows, isMomentary = true, course = course)

    fun map(operation: (Any?) -> Any?) = if (rows == null) {
        SlowValue(null, operation(single))
    } else {
        with(rows.map { Row(it.time, operation(it.value)) })
    }
}

/** A number, or a condition as one; null for a gap. */
internal fun number(value: Any?): Double? = when (value) {
    is Double -> value.takeIf { !it.isNaN() }
    is Boolean -> if (value) 1.0 else 0.0
    else -> null
}

internal fun finite(value: Any?): Double? = number(value)?.takeIf { it.isFinite() }

internal fun known(value: Any?): Any? = if (value is Double && value.isNaN()) null else value

/** Whether two known samples are the same. */
internal fun areEqual(one: Any, other: Any): Boolean {
    if (one is String || other is String) return one == other
    val left = number(one)!!
    val right = number(other)!!
    return left - right == 0.0 || (left.isInfinite() && left == right)
}

/** Times that differ by a tick of a course are the same. */
internal const val A_TICK = 1e-9
