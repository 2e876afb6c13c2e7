package badlog.expression

import badlog.analysis.EnabledSpan
import badlog.analysis.Series
import badlog.expression.samples.Column
import badlog.expression.samples.Operation
import badlog.expression.samples.Scalar
import badlog.expression.samples.Stretches
import badlog.expression.samples.Value
import badlog.expression.samples.combined
import badlog.expression.samples.equalTexts
import badlog.expression.samples.heldFor
import badlog.expression.samples.inverted
import badlog.expression.samples.matches
import badlog.expression.samples.perSecond
import badlog.expression.samples.restricted
import badlog.expression.samples.stepsOf
import badlog.expression.samples.whereText
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.syntax.Arguments
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator

/** The values of an expression's nodes over one recording, each computed once. */
internal class Evaluation(private val signals: Signals, nodes: Int) {
    private val values = arrayOfNulls<Value>(nodes)
    private val range = signals.range
    private val second = perSecond(signals.timeUnit)
    private var stretches = signals.stretches

    fun valueOf(node: Node): Value = values[node.id] ?: compute(node).also { values[node.id] = it }

    private fun compute(node: Node): Value = when (node) {
        is Node.Number -> Scalar(node.value)

        is Node.Time -> Scalar(node.seconds * second)

        is Node.Truth -> Scalar(if (node.value) 1.0 else 0.0)

        is Node.Text -> error("A text has no value of its own.")

        is Node.Topic -> columnOf(node.signal)

        is Node.Enabled -> stepsOf(signals.enabled.filter { !node.isAutonomous || it.isAutonomous }.map(EnabledSpan::span), range)

        is Node.Negative -> combined(Scalar(-1.0), valueOf(node.operand), Operation.TIMES)

        is Node.Not -> inverted(valueOf(node.operand))

        is Node.For -> (valueOf(node.condition) as Column).let { it.heldFor(node.time.seconds * second, it.end(range)) }

        is Node.Binary -> computeBinary(node)

        is Node.Call -> node.function.compute.of(
            Arguments(node.arguments.map(::valueOf), node.arguments.map { it.type.kind == Kind.CONDITION }, range),
        )
    }

    private fun computeBinary(node: Node.Binary): Value {
        val (left, right) = node.children
        return when {
            node.operator == Operator.WHEN -> restricted(valueOf(left), valueOf(right))

            node.operator == Operator.CONTAINS && right is Node.Text ->
                whereText(valueOf(left) as Column) { it.contains(right.text, ignoreCase = true) }

            node.operator == Operator.MATCHES && right is Node.Text ->
                whereText(valueOf(left) as Column) { matches(it, right.text) }

            // Between events it is known that none holds.
            node.operator.group == Operator.Group.LOGIC ->
                combined(valueOf(left), valueOf(right), node.operator.operation, absent = 0.0)

            left.type.kind == Kind.TEXT -> compareTexts(left, right, node.operator == Operator.EQUAL)

            else -> combined(valueOf(left), valueOf(right), node.operator.operation)
        }
    }

    private fun compareTexts(left: Node, right: Node, isEqual: Boolean): Value {
        val equal = when {
            left is Node.Text -> whereText(valueOf(right) as Column) { it == left.text }
            right is Node.Text -> whereText(valueOf(left) as Column) { it == right.text }
            else -> equalTexts(valueOf(left) as Column, valueOf(right) as Column)
        }
        return if (isEqual) equal else inverted(equal)
    }

    private fun columnOf(signal: Signal): Column {
        val series = signals.series(signal.name)
        val isText = signal.kind == SignalKind.STATE || signal.kind == SignalKind.EVENT
        val texts = if (isText) signals.states(signal.name) else null
        val isEvent = signal.kind == SignalKind.EVENT
        val stretches = stretchesOf(series) ?: return Column(series.x, series.y, texts, isEvent)
        return Column(stretches.steady(series.x), series.y, texts, isEvent, stretches)
    }

    private fun stretchesOf(series: Series): Stretches? {
        val isSetBack = signals.stretches?.knows(series.x) == true || !series.isOrdered
        if (isSetBack && stretches == null) stretches = Stretches(series.x)
        return if (isSetBack) stretches else null
    }
}
