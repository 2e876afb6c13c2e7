package badlog.expression

import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import kotlin.math.pow
import kotlin.math.sqrt

/** The functions over a whole log: one number from all samples. */
internal class SlowFigures(private val time: SlowTime, private val noise: Noise, private val value: SlowValue) {
    private val rows = value.rows!!
    private val found = rows.mapNotNull { row -> finite(row.value)?.let { row.time to it } }
    private val numbers = found.map { it.second }

    /** Each value, and the time for which it holds. */
    private val pieces = rows.indices.mapNotNull { i -> finite(rows[i].value)?.let { it to maxOf(0.0, time.until(value, i) - rows[i].time) } }
    private val weighty = pieces.filter { it.second > 0 }.ifEmpty { pieces.map { it.first to 1.0 } }.sortedBy { it.first }
    private val weight = weighty.sumOf { it.second }
    private val isKnown = value.isMomentary || rows.any { it.value != null }

    /** Null if the function is not one of a whole log. */
    fun of(node: Node.Call, others: List<SlowValue>): SlowValue? {
        val percent = others.getOrNull(0)?.single as? Double
        val figure: Any? = when (node.function) {
            Function.MIN -> numbers.minOrNull()
            Function.MAX -> numbers.maxOrNull()
            Function.MEAN -> if (weighty.isEmpty()) null else mean()
            Function.MEDIAN -> percentile(50.0)
            Function.PERCENTILE -> percentile(percent!!)
            Function.STDDEV -> if (weighty.isEmpty()) null else rooted(weighty.sumOf { (it.first - mean()).pow(2) * (it.second / weight) })
            Function.SAMPLE_MEAN -> if (numbers.isEmpty()) null else meanOf(numbers)
            Function.SAMPLE_MEDIAN -> samplePercentile(50.0)
            Function.SAMPLE_PERCENTILE -> samplePercentile(percent!!)
            Function.SAMPLE_STDDEV -> if (numbers.size < 2) null else rooted(numbers.sumOf { (it - numbers.average()).pow(2) } / (numbers.size - 1))
            Function.FIRST -> numbers.firstOrNull()
            Function.LAST -> numbers.lastOrNull()
            Function.INTEGRAL -> if (numbers.isEmpty()) null else noise.ofSum(pieces.sumOf { it.first * it.second })
            Function.DURATION -> duration()
            Function.COUNT -> count(node.arguments[0].type.kind == Kind.CONDITION)
            Function.TIME_OF_MIN -> logged(found.minByOrNull { it.second }?.first)
            Function.TIME_OF_MAX -> logged(found.maxByOrNull { it.second }?.first)
            Function.ANY -> isAny()
            Function.ALL -> if (rows.any { it.value == false }) false else true.takeIf { rows.any { it.value == true } }
            Function.TOTAL -> if (isKnown) noise.ofSum(time.spans(value).sumOf(time::width)) else null
            else -> return null
        }
        return SlowValue(null, figure)
    }

    private fun rooted(variance: Double) = noise.of(sqrt(variance))

    // If there is only one value, it is this value, whatever the order of calculation.
    private fun mean() = weighty.first().first.takeIf { one -> weighty.all { it.first == one } }
        ?: noise.of(weighty.sumOf { it.first * it.second } / weight)

    private fun meanOf(numbers: List<Double>) = numbers.first().takeIf { one -> numbers.all { it == one } } ?: noise.of(numbers.average())

    private fun percentile(percent: Double): Double? {
        if (weighty.isEmpty()) return null
        val wanted = weight * percent / 100
        val value = weighty.map { it.first }.first { value -> weighty.filter { it.first <= value }.sumOf { it.second } >= wanted - weight * 1e-9 }
        val reached = weighty.filter { it.first <= value }.sumOf { it.second }
        val above = weighty.firstOrNull { it.first > value }?.first ?: value
        return if (reached > wanted + weight * 1e-9) value else (value + above) / 2
    }

    private fun samplePercentile(percent: Double): Double? {
        val sorted = numbers.sorted()
        if (sorted.isEmpty()) return null
        val place = percent / 100 * sorted.lastIndex
        return sorted[place.toInt()] + (sorted[minOf(place.toInt() + 1, sorted.lastIndex)] - sorted[place.toInt()]) * (place % 1)
    }

    private fun duration(): Double? {
        val known = rows.indices.filter { rows[it].value is String || rows[it].value is Boolean || finite(rows[it].value) != null }
        return if (known.isEmpty()) null else noise.ofSum(maxOf(0.0, time.until(value, known.last()) - rows[known.first()].time))
    }

    private fun count(isCondition: Boolean): Double? = if (isCondition) {
        if (isKnown) time.spans(value).size.toDouble() else null
    } else {
        rows.count { it.value is String || finite(it.value) != null }.toDouble()
    }

    private fun isAny(): Boolean? = when {
        time.spans(value).isNotEmpty() -> true
        value.isMomentary || rows.any { it.value == false } -> false
        else -> null
    }

    private fun logged(time: Double?) = if (time == null) null else value.course?.logged(time) ?: time
}

/** How [y] depends on [x], pair by pair, weighted by [weights]. */
internal class SlowRegression(private val y: List<Double>, private val x: List<Double>, private val weights: List<Double>) {
    private val weight = weights.sum()
    private val centerX = mean(x)
    private val centerY = mean(y)
    private val squaresX = sum { (x[it] - centerX).pow(2) }
    private val squaresY = sum { (y[it] - centerY).pow(2) }
    private val products = sum { (x[it] - centerX) * (y[it] - centerY) }

    val slope: Double? get() = if (weight > 0 && squaresX > 0) products / squaresX else null

    val correlation: Double? get() = if (weight > 0 && squaresX > 0 && squaresY > 0) products / sqrt(squaresX * squaresY) else null

    private fun mean(values: List<Double>) = values.firstOrNull()?.takeIf { one -> values.all { it == one } } ?: (sum { values[it] } / weight)

    private fun sum(part: (Int) -> Double) = weights.indices.sumOf { weights[it] * part(it) }
}
