package badlog.expression.checking

import badlog.expression.signals.SampleBounds
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator
import kotlin.math.abs

/** The range of all values of something. */
private class Bounds(val low: Double, val high: Double) {
    fun isOne(): Boolean = low == high

    companion object {
        val ALL = Bounds(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
        val CONDITION = Bounds(0.0, 1.0)
    }
}

/**
 * Determines from the bounds of each topic's samples whether parts of an expression may hold. If the result is false, they never hold.
 * [ofTopic] returns the bounds, or null if they are not known.
 */
internal class BoundsCheck(private val ofTopic: (String) -> SampleBounds?) {
    /** Returns whether the condition [node] may be true at some time. */
    fun mayHold(node: Node): Boolean = when (node) {
        is Node.Truth -> node.value
        is Node.Not -> mayFail(node.operand)
        is Node.For -> mayHold(node.condition)
        is Node.Topic -> ofTopic(node.signal.name)?.let { it.high != 0.0 || it.low != 0.0 } != false
        is Node.Binary -> mayHold(node)
        is Node.Call -> mayHold(node)
        else -> true
    }

    private fun mayHold(call: Node.Call): Boolean {
        val argument = call.arguments[0]
        return when {
            call.function == Function.MISSING && argument is Node.Topic -> ofTopic(argument.signal.name)?.hasGaps != false
            call.function !in RANGE_PRESERVING || argument.type.kind != Kind.CONDITION -> true
            else -> mayHold(argument)
        }
    }

    private fun mayHold(node: Node.Binary): Boolean {
        val (left, right) = node.children
        return when (node.operator) {
            Operator.WHEN -> mayHold(left)
            Operator.AND -> mayHold(left) && mayHold(right)
            Operator.OR -> mayHold(left) || mayHold(right)
            else -> left.type.kind == Kind.TEXT || right.type.kind == Kind.TEXT || mayHold(node.operator, of(left), of(right))
        }
    }

    private fun mayHold(operator: Operator, left: Bounds, right: Bounds): Boolean = when (operator) {
        Operator.LESS -> left.low < right.high
        Operator.LESS_OR_EQUAL -> left.low <= right.high
        Operator.GREATER -> left.high > right.low
        Operator.GREATER_OR_EQUAL -> left.high >= right.low
        Operator.EQUAL -> left.low <= right.high && right.low <= left.high
        Operator.NOT_EQUAL -> !left.isOne() || !right.isOne() || left.low != right.low
        else -> true
    }

    private fun mayFail(node: Node): Boolean = when {
        node is Node.Not -> mayHold(node.operand)
        node is Node.Binary && node.operator in OPPOSITE -> mayHold(OPPOSITE.getValue(node.operator), of(node.left), of(node.right))
        else -> true
    }

    private fun of(node: Node): Bounds = when {
        // The unit after the conversion is not known yet.
        node.conversion != null -> Bounds.ALL

        node.type.kind == Kind.CONDITION -> if (mayHold(node)) Bounds.CONDITION else Bounds(0.0, 0.0)

        node is Node.Number -> Bounds(node.value, node.value)

        node is Node.Topic -> ofTopic(node.signal.name)?.let { bounds(it.low, it.high) } ?: Bounds.ALL

        node is Node.Negative -> of(node.operand).let { Bounds(-it.high, -it.low) }

        node is Node.Binary -> of(node)

        node is Node.Call -> of(node)

        else -> Bounds.ALL
    }

    private fun of(node: Node.Binary): Bounds {
        if (node.operator == Operator.WHEN) return of(node.left)
        if (node.operator != Operator.PLUS && node.operator != Operator.MINUS) return Bounds.ALL
        val left = of(node.left)
        val right = of(node.right).let { if (node.operator == Operator.PLUS) it else Bounds(-it.high, -it.low) }
        return bounds(left.low + right.low, left.high + right.high)
    }

    private fun of(call: Node.Call): Bounds {
        val topic = (call.arguments[0] as? Node.Topic)?.let { ofTopic(it.signal.name) }
        if (topic != null && call.function == Function.DELTA) return bounds(topic.minStep, topic.maxStep)
        if (topic != null && !topic.hasGaps && call.function == Function.MIN) return Bounds(topic.low, topic.low)
        if (topic != null && !topic.hasGaps && call.function == Function.MAX) return Bounds(topic.high, topic.high)
        if (call.function == Function.ABS) return of(call.arguments[0]).let { Bounds(0.0, maxOf(abs(it.low), abs(it.high))) }
        if (call.function in RANGE_PRESERVING) return of(call.arguments[0])
        if (call.function !in COUNTING || call.arguments[0].type.kind != Kind.CONDITION) return Bounds.ALL
        return if (mayHold(call.arguments[0])) Bounds.ALL else Bounds(0.0, 0.0)
    }

    // If infinities cancel each other, nothing is known.
    private fun bounds(low: Double, high: Double) = if (low.isNaN() || high.isNaN()) Bounds.ALL else Bounds(low, high)

    private companion object {
        /** The functions with results within the values of their first operand. */
        val RANGE_PRESERVING = setOf(
            Function.MIN, Function.MAX, Function.FIRST, Function.LAST, Function.WINDOW_MIN, Function.WINDOW_MAX, Function.PREVIOUS,
            Function.HOLD, Function.SHIFT_TIME, Function.ANY,
        )
        val COUNTING = setOf(Function.COUNT, Function.TOTAL)
        val OPPOSITE = mapOf(
            Operator.LESS to Operator.GREATER_OR_EQUAL,
            Operator.LESS_OR_EQUAL to Operator.GREATER,
            Operator.GREATER to Operator.LESS_OR_EQUAL,
            Operator.GREATER_OR_EQUAL to Operator.LESS,
            Operator.EQUAL to Operator.NOT_EQUAL,
            Operator.NOT_EQUAL to Operator.EQUAL,
        )
    }
}
