package badlog.expression.syntax

import badlog.core.analysis.Span
import badlog.expression.samples.Column
import badlog.expression.samples.Operation
import badlog.expression.samples.Regression
import badlog.expression.samples.Scalar
import badlog.expression.samples.Value
import badlog.expression.samples.changed
import badlog.expression.samples.chosen
import badlog.expression.samples.clamped
import badlog.expression.samples.combined

/**
 * The arguments of a function.
 *
 * @property range the range of the whole recording.
 */
internal class Arguments(private val nodes: List<Node>, private val values: List<Value>, val range: Span?) {
    fun column(index: Int): Column = values[index] as Column

    fun number(index: Int): Double = (values[index] as Scalar).value

    fun isCondition(index: Int): Boolean = nodes[index].type.kind == Kind.CONDITION

    fun text(index: Int): String = (nodes[index] as Node.Text).text

    fun regression() = Regression(values[0], values[1], range)

    /** Returns where the first operand rises above the second, or falls below it. */
    fun crossings(): Column = (combined(values[0], values[1], Operator.GREATER.operation) as Column).changed()

    fun chosen(): Value = chosen(values[0], values[1], values[2])

    fun clamped(): Value = clamped(values[0], values[1], values[2])

    /** Applies [operation] to the one operand, or to both. */
    fun elementwise(operation: Operation): Value = combined(values[0], values.getOrNull(1) ?: Scalar(Double.NaN), operation)
}
