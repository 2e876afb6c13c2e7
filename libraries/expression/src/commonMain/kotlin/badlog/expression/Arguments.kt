package badlog.expression

import badlog.analysis.Span

/**
 * What a function is called with.
 *
 * @property range of the whole recording.
 */
internal class Arguments(private val values: List<Value>, private val types: List<Type>, val range: Span?) {
    fun column(index: Int): Column = values[index] as Column

    fun number(index: Int): Double = (values[index] as Scalar).value

    fun isCondition(index: Int): Boolean = types[index].kind == Kind.CONDITION

    fun chosen(): Value = chosen(values[0], values[1], values[2])

    fun clamped(): Value = clamped(values[0], values[1], values[2])

    /** Of the one operand, or of both. */
    fun elementwise(operation: Operation): Value = combined(values[0], values.getOrNull(1) ?: Scalar(Double.NaN), operation)
}
