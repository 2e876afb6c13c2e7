package badlog.expression

import badlog.expression.syntax.Function

/** The functions that find when, how often and how long a condition holds. */
internal class SlowOccurrences(private val time: SlowTime, private val noise: Noise, private val value: SlowValue) {
    private val rows = value.rows!!
    private val spans = time.spans(value)

    /** Null if the function is not one of these. */
    fun of(function: Function, length: Double): SlowValue? = when (function) {
        Function.RISES -> value.moments(spans.map { Row(it.first, true) })
        Function.FALLS -> falls()
        Function.LENGTHS -> value.moments(spans.map { Row(it.first, noise.ofSum(it.second - it.first)) })
        Function.CYCLE_TIMES -> value.moments(spans.zipWithNext { a, b -> Row(b.first, noise.ofSum(b.first - a.first)) })
        Function.AFTER -> within(spans.map { it.first to noise.ofSum(it.second + length) })
        Function.BEFORE -> within(spans.map { noise.ofSum(it.first - length) to it.first })
        Function.FIRST_PART -> within(spans.take(1).map { it.first to minOf(it.second, noise.ofSum(it.first + length)) })
        Function.LAST_PART -> within(spans.takeLast(1).map { maxOf(it.first, noise.ofSum(it.second - length)) to it.second })
        else -> null
    }

    private fun falls() = value.moments(
        rows.indices.filter { it > 0 && !value.isMomentary && rows[it].time <= time.end(value) && rows[it].value == false && rows[it - 1].value == true }
            .map { Row(rows[it].time, true) },
    )

    /** True within [parts], from the start of the log; at its end as just before. */
    private fun within(parts: List<Pair<Double, Double>>): SlowValue {
        if (time.range == null) return SlowValue(emptyList())
        if (!value.isMomentary && rows.none { it.value != null }) return SlowValue(listOf(Row(time.begin(value), null)), course = value.course)
        val begin = time.begin(value)
        val end = time.end(value)
        fun isWithin(at: Double) = parts.any { at >= it.first && (at < it.second || (it.second == end && at == end)) }
        val edges = parts.filter { it.second > maxOf(begin, it.first) }.flatMap { (from, to) -> listOfNotNull(from, to.takeIf { it != end }) }
            .filter { it > begin }
        val times = (edges + begin).distinct().sorted()
        val steps = times.map { Row(it, isWithin(it)) }
        return SlowValue(steps.filterIndexed { i, row -> i == 0 || row.value != steps[i - 1].value }, course = value.course)
    }
}
