package badlog.expression

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Series
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
import badlog.expression.samples.refined
import badlog.expression.samples.restricted
import badlog.expression.samples.stepsOf
import badlog.expression.samples.unknown
import badlog.expression.samples.whereText
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.syntax.Arguments
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Mode
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator

/** The values of an expression's nodes over one recording, each computed once. */
internal class Evaluation(private val signals: Signals, nodes: Int) {
    private val values = arrayOfNulls<Value>(nodes)
    private val range = signals.range
    private val second = perSecond(signals.timeUnit)
    private var stretches = signals.stretches

    fun valueOf(node: Node): Value = values[node.id] ?: converted(node, compute(node)).also { values[node.id] = it }

    /** Returns whether [condition] is never true, without computing all of it if a necessary part is never true. */
    fun neverHolds(condition: Node): Boolean = when {
        condition is Node.For -> neverHolds(condition.condition)
        condition is Node.Call && condition.function == Function.ANY -> neverHolds(condition.arguments[0])
        condition is Node.Binary && condition.operator == Operator.AND && condition.children.any(::neverHolds) -> true
        else -> valueOf(condition).let { if (it is Column) it.y.none { state -> state == 1.0 } else (it as Scalar).value != 1.0 }
    }

    private fun converted(node: Node, value: Value): Value {
        val factor = node.conversion?.factor(second) ?: return value
        return if (value is Scalar) {
            Scalar(
                value.value * factor,
                value.time,
                value.spans,
            )
        } else {
            combined(Scalar(factor), value, Operation.TIMES)
        }
    }

    private fun compute(node: Node): Value = when (node) {
        is Node.Number -> Scalar(node.value)

        is Node.Measured -> Scalar(node.value)

        is Node.Time -> Scalar(node.seconds * second)

        is Node.Truth -> Scalar(if (node.value) 1.0 else 0.0)

        // Texts are compared by their words, not by a number.
        is Node.Text -> Scalar(Double.NaN)

        is Node.Topic -> columnOf(node.signal)

        is Node.Enabled -> enabled(node.mode)

        is Node.Axis -> columnOf(signals.axis)

        is Node.Negative -> combined(Scalar(-1.0), valueOf(node.operand), Operation.TIMES)

        is Node.Not -> inverted(valueOf(node.operand))

        is Node.For -> (valueOf(node.condition) as Column).let { it.heldFor(node.time.seconds * second, it.end(range)) }

        is Node.Binary -> computeBinary(node)

        is Node.Call -> node.function.compute(Arguments(node.arguments, argumentsOf(node), range))
    }

    private fun argumentsOf(call: Node.Call): List<Value> {
        val values = call.arguments.map(::valueOf)
        val first = values.firstOrNull() as? Column
        if (!call.function.needsSteps || first == null || hasEachRow(first)) return values
        return listOf(first.refined(STEP * second, first.end(range))) + values.drop(1)
    }

    /** Returns whether [column] has a sample in each row of the log. */
    private fun hasEachRow(column: Column): Boolean {
        val rows = signals.rows ?: return false
        return column.x === rows || column.x.contentEquals(stretches?.steady(rows) ?: rows)
    }

    private fun enabled(mode: Mode): Column {
        val spans = signals.enabled
        val isKnown = spans != null && (mode == Mode.ENABLED || signals.knowsAutonomous)
        if (!isKnown) return unknown(range)
        return stepsOf(
            spans.orEmpty().filter {
                mode == Mode.ENABLED || (it.isAutonomous == (mode == Mode.AUTONOMOUS) && !it.isTest)
            }.map(EnabledSpan::span),
            range,
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

            // Between events, none holds.
            node.operator.group == Operator.Group.LOGIC ->
                combined(valueOf(left), valueOf(right), node.operator.operation, absent = 0.0, isEither = node.operator == Operator.OR)

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
        return columnOf(series, texts, isEvent = signal.kind == SignalKind.EVENT)
    }

    private fun columnOf(series: Series, texts: List<String>? = null, isEvent: Boolean = false): Column {
        val stretches = stretchesOf(series) ?: return Column(series.x, series.y, texts, isEvent)
        return Column(stretches.steady(series.x), series.y, texts, isEvent, stretches)
    }

    private fun stretchesOf(series: Series): Stretches? {
        val isSetBack = signals.stretches?.knows(series.x) == true || !series.isOrdered
        if (isSetBack && stretches == null) stretches = Stretches(series.x)
        return if (isSetBack) stretches else null
    }
}

/** In seconds: the usual period of a robot's loop. */
private const val STEP = 0.02
