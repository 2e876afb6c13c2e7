package badlog.expression

import badlog.analysis.Units

/** Makes the [Answer] of the expression with the root [root], which was written as [text], over [signals]. */
internal class Answering(private val text: String, private val root: Node, private val signals: Signals) {
    private val evaluation = Evaluation(signals, root.id + 1)
    private val figures = ArrayList<Figure>()
    private val whenTrue = ArrayList<Spans>()

    fun answer(): Answer {
        val value = evaluation.valueOf(root)
        if (root.type.kind != Kind.CONDITION) {
            addNumber(value)
            return answer(Outcome.NO_QUESTION, null)
        }
        if (value is Column) {
            val whether = value.any(signals.range)
            addFigures(root, value, false)
            return answer(outcomeOf(whether), whether.spans)
        }
        val outcome = outcomeOf(value as Scalar)
        addFigures(root, null, false)
        // Those of several conditions may overlap; then the first alone says when.
        return answer(outcome, if (outcome == Outcome.HOLDS) whenTrue.firstOrNull { it.isNotEmpty() } else null)
    }

    private fun outcomeOf(scalar: Scalar) = when (scalar.value) {
        1.0 -> Outcome.HOLDS
        0.0 -> Outcome.FAILS
        else -> Outcome.UNKNOWN
    }

    private fun answer(outcome: Outcome, spans: Spans?) =
        Answer(outcome, spans.orEmpty(), spans?.times ?: 0, figures, shownUnit(signals.timeUnit))

    private fun addNumber(value: Value) = when (value) {
        is Scalar -> addFigure(root, value)

        is Column -> {
            addFigure(root, value.minimum(), "min")
            addFigure(root, value.maximum(), "max")
        }
    }

    /** Adds what is compared in [node]; [within] is the condition during which it counts, null for the whole recording. */
    private fun addFigures(node: Node, within: Column?, isNegated: Boolean) {
        when (node) {
            is Node.Not -> addFigures(node.operand, within, !isNegated)

            is Node.For -> addFigures(node.condition, within, isNegated)

            is Node.Call -> addOfCall(node, isNegated)

            is Node.Binary -> when {
                node.operator == Operator.WHEN -> addFigures(node.left, within, isNegated)

                node.operator.group == Operator.Group.LOGIC -> node.children.forEach { addFigures(it, within, isNegated) }

                node.operator.isComparison -> node.children.forEachIndexed { index, side ->
                    addSide(side, within, smallest(node.operator, isNegated != (index == 1)))
                }
            }

            else -> {}
        }
    }

    /** Of `any` what makes it true, of `all` what makes it false. */
    private fun addOfCall(call: Node.Call, isNegated: Boolean) {
        if (call.function != Function.ANY && call.function != Function.ALL) return
        (evaluation.valueOf(call) as Scalar).spans?.let { whenTrue += it }
        val condition = evaluation.valueOf(call.arguments[0]) as Column
        val isAny = call.function == Function.ANY
        addFigures(call.arguments[0], if (isAny) condition else inverted(condition) as Column, isNegated != !isAny)
    }

    /** Whether the smallest value of the left side tells most, or the largest; null when neither does. */
    private fun smallest(operator: Operator, isTurned: Boolean): Boolean? = when (operator) {
        Operator.LESS, Operator.LESS_OR_EQUAL -> !isTurned
        Operator.GREATER, Operator.GREATER_OR_EQUAL -> isTurned
        else -> null
    }

    private fun addSide(side: Node, within: Column?, smallest: Boolean?) {
        if (figures.size == MOST_FIGURES || side.type.kind == Kind.TEXT || isConstant(side)) return
        val value = evaluation.valueOf(side)
        if (value is Scalar) {
            value.spans?.let { whenTrue += it }
            addFigure(side, value)
        } else if (within != null) {
            val inside = restricted(value, within) as Column
            val found = when (smallest) {
                true -> inside.minimum()
                false -> inside.maximum()
                null -> inside.first()
            }
            if (!found.value.isNaN()) addFigure(side, found)
        }
    }

    private fun isConstant(node: Node): Boolean = node !is Node.Topic && node !is Node.Enabled && node.children.all(::isConstant)

    private fun addFigure(node: Node, found: Scalar, function: String? = null) {
        val unit = shownUnit(unitOf(node, signals.timeUnit))
        val written = text.substring(node.from, node.until)
        figures += Figure(if (function == null) written else "$function($written)", found.value, unit, found.time)
    }

    private fun shownUnit(unit: String) = if (Units.isNone(unit)) "" else unit

    private companion object {
        const val MOST_FIGURES = 8
    }
}
