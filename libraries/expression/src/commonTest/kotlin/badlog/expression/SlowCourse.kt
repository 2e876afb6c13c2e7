package badlog.expression

/** How time went in a recording whose clock was set back: on and on, by a tick where the logged time [x] went back. */
internal class SlowCourse(val x: List<Double>) {
    /** The rows, stretch by stretch. */
    private val stretches: List<List<Double>> = x.indices.filter { it == 0 || x[it] < x[it - 1] }.let { begins ->
        begins.mapIndexed { index, begin -> x.subList(begin, begins.getOrElse(index + 1) { x.size }) }
    }
    private val begins = stretches.runningFold(x[0]) { begin, stretch -> begin + (stretch.last() - stretch.first()) + TICK }

    /** Of each row. */
    val times: List<Double> = stretches.flatMapIndexed { index, stretch -> stretch.map { begins[index] + (it - stretch.first()) } }

    fun stretchOf(time: Double): Int = stretches.indices.lastOrNull { begins[it] <= time } ?: 0

    fun logged(time: Double): Double = stretchOf(time).let { time - begins[it] + stretches[it].first() }

    /** Every time at which something that was logged at [logged] counts; [isHeld] when it does after it, too. */
    fun timesOf(logged: List<Double>, isHeld: Boolean): List<Double> = stretches.flatMapIndexed { index, stretch ->
        val inside = logged.filter { (index == 0 || it >= stretch.first()) && (index == stretches.lastIndex || it <= stretch.last()) }
        inside.map { begins[index] + (it - stretch.first()) } + if (isHeld && index > 0) listOf(begins[index]) else emptyList()
    }

    private companion object {
        const val TICK = 1.0 / (1L shl 40)
    }
}
