package badlog.expression.checking

import badlog.core.analysis.Units
import badlog.expression.syntax.Conversion
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator
import badlog.expression.syntax.PhysicalUnit
import badlog.expression.syntax.mistake

/** The knowledge about the unit of some numbers. */
private sealed interface UnitOf {
    /** Literal numbers, which fit any unit. */
    object Any : UnitOf

    /** Numbers of a topic without a unit. */
    object None : UnitOf

    /** A known unit, called [text]. */
    class Known(val measure: PhysicalUnit, val text: String) : UnitOf

    /** An unknown unit, called [text]; null if even its name is not known. */
    class Other(val text: String?) : UnitOf
}

/**
 * Finds operations on different units, and converts them if both are known. A literal with a unit needs a unit on the other side; nothing
 * is guessed.
 */
internal object UnitChecker {
    /** Checks the units in [node], which already has its types. */
    fun check(node: Node) {
        unitOf(node)
    }

    private fun unitOf(node: Node): UnitOf = when (node) {
        is Node.Number -> UnitOf.Any

        is Node.Time -> UnitOf.Known(PhysicalUnit.AXIS, "")

        is Node.Axis -> UnitOf.Known(PhysicalUnit.AXIS, "")

        is Node.Measured -> known(node.unit)

        is Node.Topic -> if (node.type.kind == Kind.NUMBER) known(node.signal.unit) else UnitOf.None

        is Node.Negative -> unitOf(node.operand)

        is Node.Binary -> unitOfBinary(node)

        is Node.Call -> unitOfCall(node)

        else -> {
            node.children.forEach(::unitOf)
            UnitOf.None
        }
    }

    private fun known(unit: String): UnitOf =
        if (Units.isNone(unit)) UnitOf.None else PhysicalUnit.of(unit)?.let { UnitOf.Known(it, unit) } ?: UnitOf.Other(unit)

    private fun unitOfBinary(node: Node.Binary): UnitOf {
        val left = unitOf(node.left)
        val right = unitOf(node.right)
        return when (node.operator) {
            Operator.WHEN -> left

            Operator.PLUS, Operator.MINUS -> reconciled(node.left, left, node.right, right)

            Operator.REMAINDER -> left

            // A factor may have an implicit unit: a resistance converts amperes to volts.
            Operator.TIMES, Operator.DIVIDED_BY, Operator.POWER -> UnitOf.Other(null)

            else -> {
                if (node.operator.isComparison && node.left.type.kind.isNumeric && node.right.type.kind.isNumeric) {
                    reconciled(node.left, left, node.right, right)
                }
                UnitOf.None
            }
        }
    }

    private fun unitOfCall(node: Node.Call): UnitOf {
        val units = node.arguments.map(::unitOf)
        val first = units.firstOrNull() ?: return UnitOf.Any
        return when (node.function) {
            Function.IF -> reconciled(node.arguments[1], units[1], node.arguments[2], units[2])

            Function.CLAMP -> {
                reconciled(node.arguments[0], first, node.arguments[1], units[1])
                reconciled(node.arguments[0], first, node.arguments[2], units[2])
            }

            Function.DERIVATIVE -> (first as? UnitOf.Known)?.let { UnitOf.Known(it.measure.perAxis(), "") } ?: UnitOf.Other(null)

            Function.INTEGRAL, Function.AREA -> (first as? UnitOf.Known)?.let { UnitOf.Known(it.measure.timesAxis(), "") }
                ?: UnitOf.Other(null)

            else -> when (node.function.unit) {
                Function.UnitOfResult.AS_FIRST -> first
                Function.UnitOfResult.AXIS -> UnitOf.Known(PhysicalUnit.AXIS, "")
                Function.UnitOfResult.NONE -> UnitOf.Any
                Function.UnitOfResult.UNKNOWN -> UnitOf.Other(null)
            }
        }
    }

    /** Returns the common unit of both; converts one of them if necessary. */
    private fun reconciled(left: Node, leftUnit: UnitOf, right: Node, rightUnit: UnitOf): UnitOf {
        if (leftUnit === UnitOf.Any) return rightUnit
        if (rightUnit === UnitOf.Any) return leftUnit
        if (leftUnit is UnitOf.Known && rightUnit is UnitOf.Known) {
            if (leftUnit.measure.dimension != rightUnit.measure.dimension) {
                val place = if (isWritten(left)) left else right
                mistake(
                    place,
                    "${described(left, leftUnit)} and ${described(right, rightUnit)} have units that cannot be converted into each other.",
                )
            }
            // A literal is converted to the logged unit.
            return if (isWritten(left) && !isWritten(right)) converted(left, leftUnit, rightUnit) else converted(right, rightUnit, leftUnit)
        }
        if (isWritten(left)) failUnknown(left, right, rightUnit)
        if (isWritten(right)) failUnknown(right, left, leftUnit)
        return UnitOf.Other(null)
    }

    private fun converted(node: Node, from: UnitOf.Known, to: UnitOf.Known): UnitOf {
        val isSame = from.measure.size == to.measure.size && from.measure.axisPower == to.measure.axisPower
        if (!isSame) node.conversion = Conversion(from.measure, to.measure, to.text)
        return to
    }

    private fun isWritten(node: Node): Boolean =
        node is Node.Time || node is Node.Measured || (node is Node.Negative && isWritten(node.operand))

    private fun failUnknown(written: Node, other: Node, unit: UnitOf): Nothing {
        val what = if (other is Node.Topic) "“${other.signal.name}”" else "The other side"
        mistake(
            written,
            when {
                unit is UnitOf.Other && unit.text != null -> "$what is in “${unit.text}”, to which ${text(
                    written,
                )} cannot be converted; write the number alone."

                unit is UnitOf.Other -> "The unit of the other side is not known, so ${text(
                    written,
                )} cannot be compared with it; write the number alone."

                else -> "$what has no unit, so ${text(written)} cannot be compared with it; write the number alone, as it is logged."
            },
        )
    }

    private fun described(node: Node, unit: UnitOf.Known) = when {
        isWritten(node) -> text(node)

        node is Node.Topic -> "“${node.signal.name}” in ${unit.text}"

        unit.text.isNotEmpty() -> "numbers in ${unit.text}"

        else -> "a ${unit.measure.dimension.substringBefore('/').substringBefore('·')}" +
            if ('/' in unit.measure.dimension) " over time" else ""
    }

    private fun text(node: Node): String = when (node) {
        is Node.Time -> node.written
        is Node.Measured -> "${node.digits} ${node.unit}"
        is Node.Negative -> "-" + text(node.operand)
        else -> "this"
    }
}
