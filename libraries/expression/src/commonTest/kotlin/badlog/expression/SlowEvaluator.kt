package badlog.expression

import badlog.expression.samples.tick
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Mode
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

    fun valueOf(node: Node): SlowValue {
        val factor = node.conversion?.factor(1.0) ?: return plainValueOf(node)
        return map(plainValueOf(node)) { number(it)?.times(factor) }
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
                unknown()
            } else {
                steps(spans.filter { node.mode == Mode.ENABLED || it.isAutonomous == (node.mode == Mode.AUTONOMOUS) }.map { it.span.from to it.span.to })
            }
        }

        is Node.Negative -> map(valueOf(node.operand)) { number(it)?.let { x -> -x } }

        is Node.Not -> map(valueOf(node.operand)) { (it as Boolean?)?.not() }

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

    private fun unknown() = SlowValue(if (range == null) emptyList() else listOf(Row(range.from, null)))

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

    private fun join(values: List<SlowValue>, absent: Any?, isEither: Boolean = false, operation: (List<Any?>) -> Any?): SlowValue {
        val series = values.filter { it.rows != null }
        if (series.isEmpty()) return SlowValue(null, operation(values.map { it.single }))
        val course = series.firstNotNullOfOrNull { it.course }
        fun timesOf(value: SlowValue): List<Double> = value.rows!!.map { it.time }.let {
            if (value.course == course) it else course!!.timesOf(it, !value.isMomentary)
        }
        fun at(value: SlowValue, time: Double) = value.at(if (value.course == course) time else course!!.logged(time), absent)
        val moments = series.filter { it.isMomentary }
        val isMomentary = moments.isNotEmpty() && (!isEither || moments.size == series.size)
        val ends = if (isMomentary) emptyList() else moments.flatMap(::timesOf).map { it + tick(it) }
        val areSame = series.map { value -> value.rows!!.map { it.time } }.distinct().size == 1 && series.all { it.course == course } && ends.isEmpty()
        val ofMoments = moments.map { moment -> moment.rows!!.map { it.time } }.distinct()
        val rows = if (isMomentary && !areSame && ofMoments.size == 1 && moments.all { it.course == course }) {
            // Several events may have the same time.
            moments[0].rows!!.indices.map { i ->
                val time = moments[0].rows!![i].time
                Row(time, operation(values.map { if (it.rows != null && it.isMomentary) it.rows[i].value else at(it, time) }))
            }
        } else if (areSame) {
            series[0].rows!!.indices.map { i ->
                Row(
                    series[0].rows!![i].time,
                    operation(values.map { if (it.rows == null) it.single else it.rows[i].value }),
                )
            }
        } else {
            ((if (isMomentary) moments else series).flatMap(::timesOf) + ends).distinct().sorted().map { time -> Row(time, operation(values.map { at(it, time) })) }
        }
        return SlowValue(rows, isMomentary = isMomentary, course = course)
    }

    private fun number(value: Any?): Double? = when (value) {
        is Double -> value.takeIf { !it.isNaN() }
        is Boolean -> if (value) 1.0 else 0.0
        else -> null
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

    private fun end(value: SlowValue) = value.course?.let { maxOf(it.times.last(), value.rows!!.lastOrNull()?.time ?: 0.0) } ?: range?.to ?: 0.0

    private fun until(value: SlowValue, index: Int): Double {
        val rows = value.rows!!
        val time = rows[index].time
        return if (value.isMomentary) time else minOf(rows.getOrNull(index + 1)?.time ?: end(value), end(value))
    }

    /** When it holds: from each first true row to the next that is not, or the end. */
    private fun spans(value: SlowValue): List<Pair<Double, Double>> {
        if (value.isMomentary) return value.rows!!.filter { it.value == true }.map { it.time to it.time }
        val rows = value.rows!!.filter { it.time <= end(value) }
        return rows.indices.filter { rows[it].value == true && (it == 0 || rows[it - 1].value != true) }.map { begin ->
            val end = (begin until rows.size).firstOrNull { rows[it].value != true }
            rows[begin].time to (if (end == null) end(value) else rows[end].time)
        }
    }

    private fun heldFor(value: SlowValue, length: Double): SlowValue {
        // A tick of a course more or less is the same time.
        val long = spans(value).filter { it.second - it.first >= length - A_TICK }
        return value.with(
            value.rows!!.map { row ->
                val isLong = long.any { row.time >= it.first && (row.time < it.second || it.second == end(value)) }
                Row(row.time, if (row.value == true) isLong else row.value)
            },
        )
    }

    /** What changes while a value holds is asked for every 20 ms, but for that which is logged in rows. */
    private fun refined(value: SlowValue): SlowValue {
        val rows = value.rows!!
        if (rows.isEmpty() || rows.map { it.time } == (value.course?.times ?: signals.rows?.toList())) return value
        return value.with(
            rows.indices.flatMap { i ->
                val width = until(value, i) - rows[i].time
                val steps = if (width > 0.03) (width / 0.02 - 0.5).toInt() else 0
                (0..steps).map { Row(rows[i].time + it * 0.02, rows[i].value) }
            },
        )
    }

    private fun call(node: Node.Call): SlowValue {
        val values = node.arguments.map(::valueOf)
        val first = if (node.function.needsSteps) refined(values[0]) else values[0]
        val rows = first.rows.orEmpty()
        val finite = rows.mapNotNull { row -> number(row.value)?.takeIf { it.isFinite() }?.let { row.time to it } }
        val numbers = finite.map { it.second }
        fun one(value: Any?) = SlowValue(null, value)
        fun logged(time: Double?) = if (time == null || first.course == null) time else first.course.logged(time)
        fun finiteAt(index: Int) = number(rows[index].value)?.takeIf { it.isFinite() }
        fun window(fold: (List<Double>) -> Double) = first.with(
            rows.indices.map { i ->
                val from = rows[i].time - (values[1].single as Double)
                val begin = (0..i).lastOrNull { rows[it].time <= from + A_TICK } ?: 0
                val inside = (begin..i).mapNotNull(::finiteAt)
                Row(rows[i].time, if (inside.isEmpty()) null else fold(inside))
            },
        )
        fun windowMean() = first.with(
            rows.indices.map { i ->
                val from = rows[i].time - (values[1].single as Double)
                val begin = (0..i).lastOrNull { rows[it].time <= from + A_TICK } ?: 0
                val parts = (begin until i).mapNotNull { j -> finiteAt(j)?.let { it to rows[j + 1].time - maxOf(rows[j].time, from) } }
                val weight = parts.sumOf { it.second }
                Row(rows[i].time, if (weight > 0) parts.sumOf { it.first * it.second } / weight else finiteAt(i))
            },
        )
        fun begins(i: Int) = i == 0 || first.isMomentary || known(rows[i].value).let { a ->
            val b = known(rows[i - 1].value)
            if (a == null || b == null) (a == null) != (b == null) else !same(a, b)
        }
        fun moments(value: (Int) -> Any?) = SlowValue(rows.indices.filter(::begins).map { Row(rows[it].time, value(it)) }, isMomentary = true, course = first.course)
        fun isSetBack(a: Row, b: Row) = first.course != null && first.course.stretchOf(a.time) != first.course.stretchOf(b.time)
        fun beginOf(i: Int) = (i downTo 0).first(::begins)
        fun slopeAt(i: Int): Double? {
            val from = rows[beginOf(i)]
            val to = (i + 1 until rows.size).firstOrNull(::begins)?.let { rows[it] }
                ?: return number(from.value)?.takeIf { it.isFinite() }?.let { 0.0 }
            return if (to.time > from.time && !isSetBack(from, to)) minus(to, from)?.let { it / (to.time - from.time) } else null
        }
        fun sumUntil(last: Int): Double = (1..last).sumOf { i -> (finiteAt(i - 1) ?: 0.0) * (rows[i].time - rows[i - 1].time) }
        val pieces = rows.indices.mapNotNull { i -> finiteAt(i)?.let { it to maxOf(0.0, until(first, i) - rows[i].time) } }
        val weighty = pieces.filter { it.second > 0 }.ifEmpty { pieces.map { it.first to 1.0 } }.sortedBy { it.first }
        val weight = weighty.sumOf { it.second }
        fun percentile(percent: Double): Double? {
            if (weighty.isEmpty()) return null
            val wanted = weight * percent / 100
            val value = weighty.map { it.first }.first { value -> weighty.filter { it.first <= value }.sumOf { it.second } >= wanted - weight * 1e-9 }
            val reached = weighty.filter { it.first <= value }.sumOf { it.second }
            val above = weighty.firstOrNull { it.first > value }?.first ?: value
            return if (reached > wanted + weight * 1e-9) value else (value + above) / 2
        }
        fun samplePercentile(percent: Double): Double? {
            val sorted = numbers.sorted()
            if (sorted.isEmpty()) return null
            val place = percent / 100 * sorted.lastIndex
            return sorted[place.toInt()] + (sorted[minOf(place.toInt() + 1, sorted.lastIndex)] - sorted[place.toInt()]) * (place % 1)
        }
        fun mean() = weighty.sumOf { it.first * it.second } / weight
        val isKnown = first.isMomentary || rows.any { it.value != null }
        return when (node.function) {
            Function.MIN -> one(numbers.minOrNull())

            Function.MAX -> one(numbers.maxOrNull())

            Function.MEAN -> one(if (weighty.isEmpty()) null else mean())

            Function.MEDIAN -> one(percentile(50.0))

            Function.PERCENTILE -> one(percentile(values[1].single as Double))

            Function.STDDEV -> one(if (weighty.isEmpty()) null else sqrt(weighty.sumOf { (it.first - mean()).pow(2) * (it.second / weight) }))

            Function.SAMPLE_MEAN -> one(if (numbers.isEmpty()) null else numbers.average())

            Function.SAMPLE_MEDIAN -> one(samplePercentile(50.0))

            Function.SAMPLE_STDDEV ->
                one(if (numbers.size < 2) null else sqrt(numbers.sumOf { (it - numbers.average()).pow(2) } / (numbers.size - 1)))

            Function.FIRST -> one(numbers.firstOrNull())

            Function.LAST -> one(numbers.lastOrNull())

            Function.INTEGRAL -> one(if (numbers.isEmpty()) null else pieces.sumOf { it.first * it.second })

            Function.DURATION -> rows.indices.filter { rows[it].value is String || rows[it].value is Boolean || finiteAt(it) != null }
                .let { known -> one(if (known.isEmpty()) null else maxOf(0.0, until(first, known.last()) - rows[known.first()].time)) }

            Function.COUNT -> one(
                if (node.arguments[0].type.kind == Kind.CONDITION) {
                    if (isKnown) spans(first).size.toDouble() else null
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
            Function.TOTAL -> one(if (isKnown) spans(first).sumOf { round((it.second - it.first) * 1024) / 1024 } else null)

            Function.WINDOW_MIN -> window { it.min() }

            Function.WINDOW_MAX -> window { it.max() }

            Function.WINDOW_MEAN -> windowMean()

            Function.DELTA -> moments { i -> if (i == 0) null else minus(rows[i], rows[i - 1]) }

            Function.DERIVATIVE -> first.with(rows.indices.map { Row(rows[it].time, slopeAt(it)) })

            Function.AREA -> first.with(
                rows.indices.map { i -> Row(rows[i].time, if (number(rows[i].value)?.isFinite() == true) sumUntil(i) else null) },
            )

            Function.PREVIOUS -> first.with(rows.indices.map { i -> Row(rows[i].time, beginOf(i).let { if (it == 0) null else rows[it - 1].value }) })

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

            Function.CHANGED -> moments { i ->
                i > 0 && known(rows[i].value) != null && known(rows[i - 1].value) != null && !same(rows[i].value!!, rows[i - 1].value!!)
            }

            Function.MISSING -> map(first) { !(it is String || number(it)?.isFinite() == true) }

            Function.DURING -> {
                val from = number(values[0].single)
                val to = number(values[1].single)
                if (from == null || to == null) {
                    unknown()
                } else {
                    steps(if (from < to) listOf(from to to) else emptyList())
                }
            }

            Function.IF -> join(values, false, isEither = true) { (on, yes, no) ->
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
