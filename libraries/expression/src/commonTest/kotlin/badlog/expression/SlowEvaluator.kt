package badlog.expression

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.round
import kotlin.math.sqrt

/** A sample: a number, a condition, a text or, for a gap, null. */
internal data class Row(val time: Double, val value: Any?)

/** What a part of an expression comes to: [rows] over time, whose clock was set back where they have a [course], or [single]. */
internal class SlowValue(
    val rows: List<Row>?,
    val single: Any? = null,
    val isMomentary: Boolean = false,
    val course: SlowCourse? = null,
) {
    fun at(time: Double, absent: Any?): Any? {
        if (rows == null) return single
        val row = rows.lastOrNull { it.time <= time }
        return if (isMomentary && row?.time != time) absent else row?.value
    }
}

/** Evaluates row by row with objects, as the documentation says it, with no thought of speed. */
internal class SlowEvaluator(private val signals: Signals) {
    private val range = signals.range
    private val course = signals.vocabulary.signals.map { signals.series(it.name).x.toList() }
        .firstOrNull { x -> x.zipWithNext().any { (a, b) -> b < a } }?.let(::SlowCourse)

    fun valueOf(node: Node): SlowValue = when (node) {
        is Node.Number -> SlowValue(null, node.value)

        is Node.Time -> SlowValue(null, node.seconds)

        is Node.Truth -> SlowValue(null, node.value)

        is Node.Text -> SlowValue(null, node.text)

        is Node.Topic -> topic(node.signal)

        is Node.Enabled -> steps(
            signals.enabled.filter {
                it.isAutonomous ||
                    !node.isAutonomous
            }.map { it.span.from to it.span.to },
        )

        is Node.Negative -> map(valueOf(node.operand)) { number(it)?.let { x -> -x } }

        is Node.Not -> map(valueOf(node.operand)) { (it as Boolean?)?.not() }

        is Node.For -> heldFor(valueOf(node.condition), node.time.seconds)

        is Node.Binary -> binary(node)

        is Node.Call -> call(node)
    }

    private fun topic(signal: Signal): SlowValue {
        val series = signals.series(signal.name)
        val rows = series.x.indices.map { i ->
            val y = series.y[i]
            Row(
                series.x[i],
                when {
                    y.isNaN() -> null
                    signal.kind == SignalKind.NUMBER -> y
                    signal.kind == SignalKind.CONDITION -> y == 1.0
                    else -> signals.states(signal.name)[y.toInt()]
                },
            )
        }
        val isEvent = signal.kind == SignalKind.EVENT
        if (rows.map { it.time } != course?.x) return SlowValue(rows, isMomentary = isEvent)
        return SlowValue(rows.zip(course.times) { row, time -> Row(time, row.value) }, isMomentary = isEvent, course = course)
    }

    private fun steps(spans: List<Pair<Double, Double>>): SlowValue {
        if (range == null) return SlowValue(emptyList())
        val ends = spans.map { it.second }.filter { it < range.to }
        val times = (spans.map { it.first } + ends + range.from).filter { it >= range.from && it <= range.to }.distinct().sorted()
        return SlowValue(
            times.map { time ->
                Row(
                    time,
                    spans.any { time >= it.first && (time < it.second || it.second >= range.to) },
                )
            },
        )
    }

    private fun map(value: SlowValue, operation: (Any?) -> Any?) = if (value.rows == null) {
        SlowValue(null, operation(value.single))
    } else {
        value.with(value.rows.map { Row(it.time, operation(it.value)) })
    }

    private fun SlowValue.with(rows: List<Row>) = SlowValue(rows, isMomentary = isMomentary, course = course)

    private fun join(values: List<SlowValue>, absent: Any?, operation: (List<Any?>) -> Any?): SlowValue {
        val series = values.filter { it.rows != null }
        if (series.isEmpty()) return SlowValue(null, operation(values.map { it.single }))
        val course = series.firstNotNullOfOrNull { it.course }
        fun timesOf(value: SlowValue): List<Double> = value.rows!!.map { it.time }.let {
            if (value.course == course) it else course!!.timesOf(it, !value.isMomentary)
        }
        fun at(value: SlowValue, time: Double) = value.at(if (value.course == course) time else course!!.logged(time), absent)
        val areSame = series.map { value -> value.rows!!.map { it.time } }.distinct().size == 1 && series.all { it.course == course }
        val rows = if (areSame) {
            series[0].rows!!.indices.map { i ->
                Row(
                    series[0].rows!![i].time,
                    operation(values.map { if (it.rows == null) it.single else it.rows[i].value }),
                )
            }
        } else {
            series.flatMap(::timesOf).distinct().sorted().map { time -> Row(time, operation(values.map { at(it, time) })) }
        }
        return SlowValue(rows, isMomentary = series.all { it.isMomentary }, course = course)
    }

    private fun number(value: Any?): Double? = when (value) {
        is Double -> value.takeIf { !it.isNaN() }
        is Boolean -> if (value) 1.0 else 0.0
        else -> null
    }

    private fun binary(node: Node.Binary): SlowValue {
        val absent: Any? = if (node.operator.group == Operator.Group.LOGIC) false else null
        return join(listOf(valueOf(node.left), valueOf(node.right)), absent) { (a, b) ->
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
                    if (left == null || right == null) null else isEqual(left, right) == (node.operator == Operator.EQUAL)
                }

                else -> arithmetic(node.operator, number(a) ?: return@join null, number(b) ?: return@join null)
            }
        }
    }

    private fun isEqual(left: Any, right: Any) = if (left is Double && right is Double) {
        left - right == 0.0 || (left.isInfinite() && left == right)
    } else {
        left == right
    }

    private fun glob(text: String, pattern: String): Boolean = when {
        pattern.isEmpty() -> text.isEmpty()

        pattern[0] == '*' -> (0..text.length).any { glob(text.substring(it), pattern.substring(1)) }

        text.isEmpty() -> false

        else -> (pattern[0] == '?' || pattern[0].lowercaseChar() == text[0].lowercaseChar()) &&
            glob(text.substring(1), pattern.substring(1))
    }

    private fun arithmetic(operator: Operator, a: Double, b: Double): Any? = when (operator) {
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

    private fun end(value: SlowValue) = maxOf(value.course?.times?.last() ?: range!!.to, value.rows!!.last().time)

    /** When it holds: from each first true row to the next that is not, or the end. */
    private fun spans(value: SlowValue): List<Pair<Double, Double>> {
        val rows = value.rows!!
        if (value.isMomentary) return rows.filter { it.value == true }.map { it.time to it.time }
        return rows.indices.filter { rows[it].value == true && (it == 0 || rows[it - 1].value != true) }.map { begin ->
            val end = (begin until rows.size).firstOrNull { rows[it].value != true }
            rows[begin].time to (if (end == null) end(value) else rows[end].time)
        }
    }

    private fun heldFor(value: SlowValue, length: Double): SlowValue {
        val rows = value.rows!!
        val begins = spans(value).map { it.first }
        // A tick of a course more or less is the same time.
        val own = rows.map { row ->
            Row(row.time, if (row.value == true) row.time >= begins.last { it <= row.time } + length - A_TICK else row.value)
        }
        val put = begins.map { it + length }.filter { time ->
            time <= end(value) && rows.none { abs(it.time - time) < A_TICK } &&
                begins.last { it <= time } == time - length &&
                value.at(time, null) == true
        }.map { Row(it, true) }
        return value.with((own + put).sortedBy { it.time })
    }

    private fun call(node: Node.Call): SlowValue {
        val values = node.arguments.map(::valueOf)
        val first = values[0]
        val rows = first.rows.orEmpty()
        val finite = rows.mapNotNull { row -> number(row.value)?.takeIf { it.isFinite() }?.let { row.time to it } }
        val numbers = finite.map { it.second }
        fun one(value: Any?) = SlowValue(null, value)
        fun logged(time: Double?) = if (time == null || first.course == null) time else first.course.logged(time)
        fun window(fold: (List<Double>) -> Double) = first.with(
            rows.indices.map { i ->
                val inside = (0..i).filter { rows[it].time > rows[i].time - (values[1].single as Double) }
                    .mapNotNull { number(rows[it].value)?.takeIf { value -> value.isFinite() } }
                Row(rows[i].time, if (inside.isEmpty()) null else fold(inside))
            },
        )
        fun beside(operation: (Row, Row) -> Any?, atFirst: Any? = null) = first.with(
            rows.indices.map { i -> Row(rows[i].time, if (i == 0) atFirst else operation(rows[i - 1], rows[i])) },
        )
        fun isSetBack(a: Row, b: Row) = first.course != null && first.course.stretchOf(a.time) != first.course.stretchOf(b.time)
        fun sumUntil(last: Int): Double = (1..last).sumOf { i ->
            val a = number(rows[i - 1].value)
            val b = number(rows[i].value)
            if (a == null || b == null || !a.isFinite() || !b.isFinite()) 0.0 else (rows[i].time - rows[i - 1].time) * (a + b) / 2
        }
        fun percentile(percent: Double): Double? {
            val sorted = numbers.sorted()
            if (sorted.isEmpty()) return null
            val place = percent / 100 * sorted.lastIndex
            return sorted[place.toInt()] + (
                sorted[
                    minOf(
                        place.toInt() + 1,
                        sorted.lastIndex,
                    ),
                ] - sorted[place.toInt()]
                ) * (place % 1)
        }
        return when (node.function) {
            Function.MIN -> one(numbers.minOrNull())

            Function.MAX -> one(numbers.maxOrNull())

            Function.MEAN -> one(if (numbers.isEmpty()) null else numbers.sum() / numbers.size)

            Function.MEDIAN -> one(percentile(50.0))

            Function.PERCENTILE -> one(percentile(values[1].single as Double))

            Function.STDDEV -> one(if (numbers.size < 2) null else sqrt(numbers.sumOf { (it - numbers.average()).pow(2) } / (numbers.size - 1)))

            Function.FIRST -> one(numbers.firstOrNull())

            Function.LAST -> one(numbers.lastOrNull())

            Function.INTEGRAL -> one(if (numbers.isEmpty()) null else sumUntil(rows.lastIndex))

            Function.DURATION -> rows.filter { it.value is String || it.value is Boolean || number(it.value)?.isFinite() == true }
                .let { known -> one(if (known.isEmpty()) null else known.last().time - known.first().time) }

            Function.COUNT -> one(
                if (node.arguments[0].type.kind == Kind.CONDITION) {
                    spans(first).size.toDouble()
                } else {
                    rows.count { it.value is String || number(it.value)?.isFinite() == true }.toDouble()
                },
            )

            Function.TIME_OF_MIN -> one(logged(finite.minByOrNull { it.second }?.first))

            Function.TIME_OF_MAX -> one(logged(finite.maxByOrNull { it.second }?.first))

            Function.ANY -> one(
                if (rows.any { it.value == true }) {
                    true
                } else if (first.isMomentary ||
                    rows.any { it.value == false }
                ) {
                    false
                } else {
                    null
                },
            )

            Function.ALL -> one(
                if (rows.any { it.value == false }) {
                    false
                } else if (rows.any { it.value == true }) {
                    true
                } else {
                    null
                },
            )

            // No tick of a course counts.
            Function.TOTAL -> one(spans(first).sumOf { round((it.second - it.first) * 1024) / 1024 })

            Function.WINDOW_MIN -> window { it.min() }

            Function.WINDOW_MAX -> window { it.max() }

            Function.WINDOW_MEAN -> window { it.sum() / it.size }

            Function.DELTA -> beside({ a, b -> minus(b, a) })

            Function.DERIVATIVE -> beside({ a, b -> if (b.time > a.time && !isSetBack(a, b)) minus(b, a)?.let { it / (b.time - a.time) } else null })

            Function.AREA -> first.with(
                rows.indices.map { i -> Row(rows[i].time, if (number(rows[i].value)?.isFinite() == true) sumUntil(i) else null) },
            )

            Function.PREVIOUS -> beside({ a, _ -> a.value })

            Function.HOLD -> SlowValue(
                rows.indices.map { i ->
                    Row(
                        rows[i].time,
                        (i downTo 0).firstNotNullOfOrNull { known(rows[it].value) },
                    )
                },
                course = first.course,
            )

            Function.SHIFT_TIME -> first.with(rows.map { Row(it.time + values[1].single as Double, it.value) })

            Function.CHANGED -> beside({ a, b ->
                known(a.value) != null && known(b.value) != null &&
                    !same(a.value!!, b.value!!)
            }, false)

            Function.MISSING -> map(first) { !(it is String || number(it)?.isFinite() == true) }

            Function.DURING -> {
                val from = number(values[0].single)
                val to = number(values[1].single)
                if (from == null || to == null) {
                    SlowValue(if (range == null) emptyList() else listOf(Row(range.from, null)))
                } else {
                    steps(if (from < to) listOf(from to to) else emptyList())
                }
            }

            Function.IF -> join(values, false) { (on, yes, no) ->
                if (on == true) {
                    yes
                } else if (on == false) {
                    no
                } else {
                    null
                }
            }

            Function.CLAMP -> join(values, 0.0) { (x, low, high) ->
                val sample = number(x)
                val least = number(low)
                val most = number(high)
                if (sample == null || least == null || most == null) null else minOf(maxOf(sample, least), most)
            }

            Function.ABS -> map(first) { number(it)?.let { x -> abs(x) } }

            Function.SQRT -> map(first) { number(it)?.let { x -> sqrt(x) } }

            else -> error("Not among the random expressions: ${node.function}")
        }
    }

    private fun known(value: Any?): Any? = if (value is Double && value.isNaN()) null else value

    private fun same(a: Any, b: Any) = if (a is String) a == b else isEqual(number(a)!!, number(b)!!)

    private fun minus(b: Row, a: Row): Double? = number(b.value)?.let { y -> number(a.value)?.let { y - it } }

    private companion object {
        const val A_TICK = 1e-9
    }
}
