package badlog.expression

/** The course of time after a clock was set back. It only advances, by a [tick] where the logged time [x] went back. */
internal class SlowCourse(val x: List<Double>, tick: Double) {
    /** The rows, stretch by stretch. */
    private val stretches: List<List<Double>> = x.indices.filter { it == 0 || x[it] < x[it - 1] }.let { begins ->
        begins.mapIndexed { index, begin -> x.subList(begin, begins.getOrElse(index + 1) { x.size }) }
    }
    private val begins = stretches.runningFold(x[0]) { begin, stretch -> begin + (stretch.last() - stretch.first()) + tick }

    /** The time of each row in this course. */
    val times: List<Double> = stretches.flatMapIndexed { index, stretch -> stretch.map { begins[index] + (it - stretch.first()) } }

    fun stretchOf(time: Double): Int = stretches.indices.lastOrNull { begins[it] <= time } ?: 0

    fun logged(time: Double): Double = stretchOf(time).let { time - begins[it] + stretches[it].first() }

    /**
     * Returns the samples of [value] on this clock, repeated each time that their times occur. The clock of [value] was never set back.
     * Unless [value] is [momentary][SlowValue.isMomentary], it also holds from the start of each stretch.
     */
    fun spread(value: SlowValue): SlowValue = SlowValue(
        stretches.flatMapIndexed { index, stretch ->
            val rows = value.rows!!.filter { index == stretches.lastIndex || it.time <= stretch.last() }
            val (before, inside) = rows.partition { index > 0 && if (value.isMomentary) it.time < stretch.first() else it.time <= stretch.first() }
            val held = if (index > 0 && !value.isMomentary) listOf(Row(begins[index], before.lastOrNull()?.value)) else emptyList()
            held + inside.map { Row(begins[index] + (it.time - stretch.first()), it.value) }
        },
        isMomentary = value.isMomentary,
        course = this,
    )
}
