package badlog.expression

import badlog.expression.samples.tick
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.syntax.Function
import badlog.expression.syntax.Mode
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.pow
import kotlin.math.round
import kotlin.math.sign
import kotlin.math.sqrt

/** Evaluates row by row with objects, just as documented, without regard to speed; rounds with [noise]. */
internal class SlowEvaluator(private val signals: Signals, private val noise: Noise = Noise.NONE) {
    private val time = SlowTime(signals, noise)
    private val course = time.course

    fun valueOf(node: Node): SlowValue {
        val factor = node.conversion?.factor(1.0) ?: return plainValueOf(node)
        return plainValueOf(node).map { number(it)?.times(factor) }
    }

    private fun plainValueOf(node: Node): SlowValue = when (node) {
        is Node.Number -> SlowValue(null, node.value)

        is Node.Measured -> SlowValue(null, node.value)

        is Node.Axis -> valueOf(signals.axis.x.toList()) { it }

        is Node.Time -> SlowValue(null, node.seconds)

        is Node.Truth -> SlowValue(null, node.value)

        is Node.Text -> SlowValue(null, node.text)

        is Node.Topic -> topic(node.signal)

        is Node.Enabled -> {
            val spans = signals.enabled
            if (spans == null) {
                time.unknown()
            } else {
                time.steps(
                    spans.filter { node.mode == Mode.ENABLED || it.isAutonomous == (node.mode == Mode.AUTONOMOUS) }.map { it.span.from to it.span.to },
                )
            }
        }

        is Node.Negative -> valueOf(node.operand).map { number(it)?.let { x -> -x } }

        is Node.Not -> valueOf(node.operand).map { (it as Boolean?)?.not() }

        is Node.For -> heldFor(valueOf(node.condition), node.time.seconds)

        is Node.Binary -> binary(node)

        is Node.Call -> call(node)
    }

    private fun topic(signal: Signal): SlowValue {
        val series = signals.series(signal.name)
        val isEvent = signal.kind == SignalKind.EVENT
        var next = 0
        return valueOf(series.x.toList(), isEvent) {
            val y = series.y[next++]
            when {
                y.isNaN() -> null
                signal.kind == SignalKind.NUMBER -> y
                signal.kind == SignalKind.CONDITION -> y == 1.0
                else -> signals.states(signal.name)[y.toInt()]
            }
        }
    }

    private fun valueOf(x: List<Double>, isMomentary: Boolean = false, value: (Double) -> Any?): SlowValue {
        val rows = x.map { Row(it, value(it)) }
        if (x != course?.x) return SlowValue(rows, isMomentary = isMomentary)
        return SlowValue(rows.zip(course.times) { row, time -> Row(time, row.value) }, isMomentary = isMomentary, course = course)
    }

    private fun join(operands: List<SlowValue>, absent: Any?, isEither: Boolean = false, operation: (List<Any?>) -> Any?): SlowValue {
        val course = operands.firstNotNullOfOrNull { it.course }
        val values = operands.map { if (it.rows == null || it.course == course) it else course!!.spread(it) }
        val series = values.filter { it.rows != null }
        if (series.isEmpty()) return SlowValue(null, operation(values.map { it.single }))
        fun timesOf(value: SlowValue) = value.rows!!.map { it.time }
        val moments = series.filter { it.isMomentary }
        val isMomentary = moments.isNotEmpty() && (!isEither || moments.size == series.size)
        val ends = if (isMomentary) emptyList() else moments.flatMap(::timesOf).map { it + tick(it) }
        val areSame = series.map(::timesOf).distinct().size == 1 && ends.isEmpty()
        val rows = if (isMomentary && !areSame && moments.map(::timesOf).distinct().size == 1) {
            // Several events may have the same time.
            moments[0].rows!!.mapIndexed { i, (time) ->
                Row(time, operation(values.map { if (it.rows != null && it.isMomentary) it.rows[i].value else it.at(time, absent) }))
            }
        } else if (areSame) {
            series[0].rows!!.mapIndexed { i, (time) -> Row(time, operation(values.map { if (it.rows == null) it.single else it.rows[i].value })) }
        } else {
            ((if (isMomentary) moments else series).flatMap(::timesOf) + ends).distinct().sorted()
                .map { time -> Row(time, operation(values.map { it.at(time, absent) })) }
        }
        return SlowValue(rows, isMomentary = isMomentary, course = course)
    }

    private fun binary(node: Node.Binary): SlowValue {
        val absent: Any? = if (node.operator.group == Operator.Group.LOGIC) false else null
        return join(listOf(valueOf(node.left), valueOf(node.right)), absent, isEither = node.operator == Operator.OR) { (a, b) ->
            when (node.operator) {
                Operator.WHEN -> if (b == true) a else null

                Operator.OR -> if (a == true || b == true) {
                    true
                } else if (a == null || b == null) {
                    null
                } else {
                    false
                }

                Operator.AND -> if (a == false || b == false) {
                    false
                } else if (a == null || b == null) {
                    null
                } else {
                    true
                }

                Operator.CONTAINS -> if (a == null) null else (b as String).lowercase() in (a as String).lowercase()

                Operator.MATCHES -> if (a == null) null else glob(a as String, b as String)

                Operator.EQUAL, Operator.NOT_EQUAL -> {
                    val left = a as? String ?: number(a)
                    val right = b as? String ?: number(b)
                    if (left == null || right == null) null else areEqual(left, right) == (node.operator == Operator.EQUAL)
                }

                else -> calculated(node.operator, number(a) ?: return@join null, number(b) ?: return@join null)
            }
        }
    }

    private fun glob(text: String, pattern: String): Boolean = when {
        pattern.isEmpty() -> text.isEmpty()

        pattern[0] == '*' -> (0..text.length).any { glob(text.substring(it), pattern.substring(1)) }

        text.isEmpty() -> false

        else -> (pattern[0] == '?' || pattern[0].lowercaseChar() == text[0].lowercaseChar()) &&
            glob(text.substring(1), pattern.substring(1))
    }

    private fun calculated(operator: Operator, a: Double, b: Double): Any? = when (operator) {
        Operator.LESS -> a < b
        Operator.LESS_OR_EQUAL -> a <= b
        Operator.GREATER -> a > b
        Operator.GREATER_OR_EQUAL -> a >= b
        Operator.PLUS -> a + b
        Operator.MINUS -> a - b
        Operator.TIMES -> a * b
        Operator.DIVIDED_BY -> a / b
        Operator.REMAINDER -> a % b
        else -> a.pow(b)
    }

    private fun heldFor(value: SlowValue, length: Double): SlowValue {
        val long = time.spans(value).filter { it.second - it.first >= length - A_TICK }
        return value.with(
            value.rows!!.map { row ->
                val isLong = long.any { row.time >= it.first && (row.time < it.second || it.second == time.end(value)) }
                Row(row.time, if (row.value == true) isLong else row.value)
            },
        )
    }

    private fun call(node: Node.Call): SlowValue {
        val values = node.arguments.map(::valueOf)
        val first = if (node.function.needsSteps) time.refined(values[0]) else values[0]
        return when (node.function) {
            Function.SLOPE, Function.CORRELATION -> regression(node.function, values)

            Function.CROSSES -> SlowChanges(noise, join(values, null) { (a, b) -> number(a)?.let { x -> number(b)?.let { x > it } } })
                .of(Function.CHANGED, 0.0)!!

            Function.MISSING -> first.map { !(it is String || finite(it) != null) }

            Function.TEXT_NUMBER -> first.map { (it as String?)?.let { text -> numberIn(text) } }

            Function.TEXT_NUMBER_AFTER -> first.map { (it as String?)?.let { text -> numberBehind(text, values[1].single as String) } }

            Function.DURING -> during(number(values[0].single), number(values[1].single))

            Function.IF -> join(values, false, isEither = true) { (on, yes, no) -> if (on == true) yes else no.takeIf { on == false } }

            Function.CLAMP -> join(values, 0.0) { (x, low, high) ->
                number(x)?.let { sample -> number(low)?.let { least -> number(high)?.let { minOf(maxOf(sample, least), it) } } }
            }

            Function.ABS -> first.map { number(it)?.let { x -> abs(x) } }

            Function.SQRT -> first.map { number(it)?.let { x -> sqrt(x) } }

            Function.SIGN -> first.map { number(it)?.let { x -> sign(x) } }

            Function.FLOOR -> first.map { number(it)?.let { x -> floor(x) } }

            Function.ROUND -> first.map { number(it)?.let { x -> round(x) } }

            else -> {
                val length = values.getOrNull(1)?.single as? Double ?: 0.0
                SlowChanges(noise, first).of(node.function, length)
                    ?: SlowOccurrences(time, noise, first).of(node.function, length)
                    ?: SlowFigures(time, noise, first).of(node, values.drop(1))
                    ?: error("Not among the random expressions: ${node.function}")
            }
        }
    }

    private fun during(from: Double?, to: Double?) = if (from == null || to == null) time.unknown() else time.steps(if (from < to) listOf(from to to) else emptyList())

    private fun regression(function: Function, values: List<SlowValue>): SlowValue {
        val pairs = join(values, null) { it.map(::finite) }
        val weights = pairs.rows!!.indices.map { if (pairs.isMomentary) 1.0 else maxOf(0.0, time.until(pairs, it) - pairs.rows[it].time) }
        val (y, x) = (0..1).map { side -> pairs.rows.map { (it.value as List<*>)[side] as Double? } }
        val known = pairs.rows.indices.filter { y[it] != null && x[it] != null && weights[it] > 0 }
        val regression = SlowRegression(known.map { y[it]!! }, known.map { x[it]!! }, known.map { weights[it] })
        return SlowValue(null, (if (function == Function.SLOPE) regression.slope else regression.correlation)?.let(noise::of))
    }

    /** The first number in [text] that is not a part of a word. */
    private fun numberIn(text: String): Double? = text.split(' ').firstNotNullOfOrNull { it.trimEnd(',', '.').toDoubleOrNull() }

    private fun numberBehind(text: String, mark: String): Double? = text.indexOf(mark, ignoreCase = true).takeIf { it >= 0 }?.let { numberIn(text.substring(it + mark.length)) }
}
