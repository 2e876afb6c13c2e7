package badlog.expression.checking

import badlog.analysis.Units
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator

/** The unit of what [node] gives where it is plain to see, else empty. Times are in [timeUnit]. */
internal fun unitOf(node: Node, timeUnit: String): String = when (node) {
    is Node.Topic -> if (Units.isNone(node.signal.unit)) "" else node.signal.unit

    is Node.Time -> timeUnit

    is Node.Negative -> unitOf(node.operand, timeUnit)

    is Node.Binary -> when (node.operator) {
        Operator.WHEN -> unitOf(node.left, timeUnit)
        Operator.PLUS, Operator.MINUS -> unitOf(node.left, timeUnit).takeIf { it == unitOf(node.right, timeUnit) }.orEmpty()
        else -> ""
    }

    is Node.Call -> unitOf(node, timeUnit)

    else -> ""
}

private fun unitOf(call: Node.Call, timeUnit: String): String {
    val first = if (call.arguments[0].type.kind == Kind.CONDITION) "" else unitOf(call.arguments[0], timeUnit)
    return when (call.function) {
        Function.MIN, Function.MAX, Function.MEAN, Function.MEDIAN, Function.PERCENTILE, Function.STDDEV, Function.FIRST,
        Function.LAST, Function.WINDOW_MIN, Function.WINDOW_MAX, Function.WINDOW_MEAN, Function.DELTA, Function.PREVIOUS,
        Function.HOLD, Function.SHIFT_TIME, Function.ABS, Function.FLOOR, Function.CEIL, Function.ROUND, Function.CLAMP,
        -> first

        Function.DURATION, Function.TOTAL, Function.TIME_OF_MIN, Function.TIME_OF_MAX -> timeUnit

        Function.DERIVATIVE -> if (first.isEmpty()) "" else Units.ofDerivative(first, timeUnit)

        Function.INTEGRAL, Function.AREA -> if (first.isEmpty()) "" else Units.ofIntegral(first, timeUnit)

        else -> ""
    }
}
