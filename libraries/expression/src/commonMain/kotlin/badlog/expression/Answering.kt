package badlog.expression

import badlog.core.analysis.Units
import badlog.expression.checking.unitOf
import badlog.expression.samples.Column
import badlog.expression.samples.Scalar
import badlog.expression.samples.Spans
import badlog.expression.samples.Value
import badlog.expression.samples.any
import badlog.expression.samples.first
import badlog.expression.samples.inverted
import badlog.expression.samples.maximum
import badlog.expression.samples.minimum
import badlog.expression.samples.restricted
import badlog.expression.signals.Signals
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Mode
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator

/** Calculates the [Answer] of the expression [text], with the root [root], over [signals]. */
internal class Answering(private val text: String, private val root: Node, private val signals: Signals) {
    private val evaluation = Evaluation(signals, root.id + 1)
    private val quantities = ArrayList<Quantity>()
    private val whenTrue = ArrayList<Spans>()

    // The samples of the first quantity, to find it again in a part of the time.
    private var first: SpannedQuantity? = null
    private val reasonUnknown = reasonUnknown(root)

    fun answer(): Answer {
        val value = evaluation.valueOf(root)
        if (root.type.kind != Kind.CONDITION) {
            addNumber(value)
            return answer(Outcome.NO_QUESTION, null)
        }
        if (value is Column) {
            val holds = value.any(signals.range)
            addQuantities(root, value, false)
            // The answer may be unknown because the mode is unknown.
            val isDoubtful = reasonUnknown != null && holds.value != 1.0 && value.y.any { it.isNaN() }
            return answer(if (isDoubtful) Outcome.UNKNOWN else outcomeOf(holds), holds.spans)
        }
        val outcome = if (reasonUnknown == null) outcomeOf(value as Scalar) else Outcome.UNKNOWN
        addQuantities(root, null, false)
        // The spans of several conditions may overlap; then only the first condition's count.
        return answer(outcome, if (outcome == Outcome.HOLDS) whenTrue.firstOrNull { it.isNotEmpty() } else null)
    }

    fun answerIfHolds(): Answer? = if (evaluation.neverHolds(root)) null else answer().takeIf { it.matches }

    private fun outcomeOf(scalar: Scalar) = when (scalar.value) {
        1.0 -> Outcome.HOLDS
        0.0 -> Outcome.FAILS
        else -> Outcome.UNKNOWN
    }

    private fun answer(outcome: Outcome, spans: Spans?) = Answer(
        outcome,
        spans.orEmpty(),
        spans?.times ?: 0,
        quantities,
        shownUnit(signals.timeUnit),
        reasonUnknown.takeIf { isOpen(outcome) },
        firstOver = { some -> first?.over(some) ?: some.map { null } },
    )

    private fun isOpen(outcome: Outcome) =
        outcome == Outcome.UNKNOWN || (outcome == Outcome.NO_QUESTION && quantities.all { it.value.isNaN() })

    /** Returns the reason why an expression that depends on the robot's mode is not known. */
    private fun reasonUnknown(node: Node): String? {
        if (node is Node.Enabled) {
            if (signals.enabled == null) return "The log does not show when the robot was enabled."
            if (node.mode != Mode.ENABLED && !signals.knowsAutonomous) return "The log does not show when the robot was autonomous."
        }
        return node.children.firstNotNullOfOrNull(::reasonUnknown)
    }

    private fun addNumber(value: Value) = when (value) {
        is Scalar -> addQuantity(root, value)

        is Column -> {
            addQuantity(root, value.minimum(), "min")
            addQuantity(root, value.maximum(), "max")
        }
    }

    /** Adds the quantities compared in [node]; [within] is the condition during which they count, null for the whole recording. */
    private fun addQuantities(node: Node, within: Column?, isNegated: Boolean) {
        when (node) {
            is Node.Not -> addQuantities(node.operand, within, !isNegated)

            is Node.For -> addQuantities(node.condition, within, isNegated)

            is Node.Call -> addOfCall(node, isNegated)

            is Node.Binary -> when {
                node.operator == Operator.WHEN -> addQuantities(node.left, within, isNegated)

                node.operator.group == Operator.Group.LOGIC -> node.children.forEach { addQuantities(it, within, isNegated) }

                node.operator.isComparison -> node.children.forEachIndexed { index, side ->
                    addSide(side, within, smallest(node.operator, isNegated != (index == 1)))
                }
            }

            else -> {}
        }
    }

    /** Adds, for `any`, what makes it true; for `all`, what makes it false. */
    private fun addOfCall(call: Node.Call, isNegated: Boolean) {
        if (call.function != Function.ANY && call.function != Function.ALL) return
        (evaluation.valueOf(call) as Scalar).spans?.let { whenTrue += it }
        val condition = evaluation.valueOf(call.arguments[0]) as Column
        val isAny = call.function == Function.ANY
        addQuantities(call.arguments[0], if (isAny) condition else inverted(condition) as Column, isNegated != !isAny)
    }

    /** Returns whether the smallest value of the left side decides, rather than the largest; null if neither does. */
    private fun smallest(operator: Operator, isTurned: Boolean): Boolean? = when (operator) {
        Operator.LESS, Operator.LESS_OR_EQUAL -> !isTurned
        Operator.GREATER, Operator.GREATER_OR_EQUAL -> isTurned
        else -> null
    }

    private fun addSide(side: Node, within: Column?, smallest: Boolean?) {
        if (quantities.size == MAX_QUANTITIES || side.type.kind == Kind.TEXT || isConstant(side)) return
        val value = evaluation.valueOf(side)
        if (value is Scalar) {
            value.spans?.let { whenTrue += it }
            addQuantity(side, value)
        } else if (within != null) {
            val inside = restricted(value, within) as Column
            val found = when (smallest) {
                true -> inside.minimum()
                false -> inside.maximum()
                null -> inside.first()
            }
            if (found.value.isNaN()) return
            addQuantity(side, found)
            if (quantities.size == 1) first = SpannedQuantity(quantities[0], inside, smallest)
        }
    }

    private fun isConstant(node: Node): Boolean =
        node !is Node.Topic && node !is Node.Enabled && node !is Node.Axis && node.children.all(::isConstant)

    private fun addQuantity(node: Node, scalar: Scalar, function: String? = null) {
        val found = if (!node.type.isOverTime && reasonUnknown(node) != null) Scalar(Double.NaN) else scalar
        val unit = shownUnit(unitOf(node, signals.timeUnit))
        val written = text.substring(node.from, node.until)
        quantities += Quantity(if (function == null) written else "$function($written)", found.value, unit, found.time)
    }

    private fun shownUnit(unit: String) = if (Units.isNone(unit)) "" else unit
}

private const val MAX_QUANTITIES = 8
