package badlog.expression.checking

import badlog.core.analysis.Units
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator

/** Returns the unit of the result of [node] if it is obvious, otherwise empty. Times are in [timeUnit]. */
internal fun unitOf(node: Node, timeUnit: String): String {
    node.conversion?.let { return it.unit.ifEmpty { timeUnit } }
    return when (node) {
        is Node.Topic -> if (Units.isNone(node.signal.unit)) "" else node.signal.unit

        is Node.Time, is Node.Axis -> timeUnit

        is Node.Measured -> node.unit

        is Node.Negative -> unitOf(node.operand, timeUnit)

        is Node.Binary -> when (node.operator) {
            Operator.WHEN -> unitOf(node.left, timeUnit)
            Operator.PLUS, Operator.MINUS -> unitOf(node.left, timeUnit).takeIf { it == unitOf(node.right, timeUnit) }.orEmpty()
            else -> ""
        }

        is Node.Call -> unitOf(node, timeUnit)

        else -> ""
    }
}

private fun unitOf(call: Node.Call, timeUnit: String): String {
    val first = call.arguments.firstOrNull()?.takeIf { it.type.kind != Kind.CONDITION }?.let { unitOf(it, timeUnit) }.orEmpty()
    return when (call.function) {
        Function.DERIVATIVE -> if (first.isEmpty()) "" else Units.ofDerivative(first, timeUnit)

        Function.INTEGRAL, Function.AREA -> if (first.isEmpty()) "" else Units.ofIntegral(first, timeUnit)

        else -> when (call.function.unit) {
            Function.UnitOfResult.AS_FIRST -> first
            Function.UnitOfResult.AXIS -> timeUnit
            else -> ""
        }
    }
}
