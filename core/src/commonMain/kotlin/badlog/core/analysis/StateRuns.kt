package badlog.core.analysis

/**
 * The runs of a series of states. Run `i` has the state [states]`[i]` from [from]`[i]` to [to]`[i]`, where the next run begins. The last
 * one lasts until [end], because a topic that is logged when it changes keeps its state.
 */
public class StateRuns(series: Series, end: Double) {
    /** Where each run begins. */
    public val from: DoubleArray

    /** Where each run ends. */
    public val to: DoubleArray

    /** The state of each run. */
    public val states: IntArray

    init {
        val x = series.x
        val y = series.y
        val starts = ArrayList<Int>()
        for (i in 0 until series.size) {
            if (i == 0 || x[i] < x[i - 1] || !isSame(y[i], y[i - 1])) starts += i
        }
        val runs = starts.filter { y[it].isFinite() }
        from = DoubleArray(runs.size)
        to = DoubleArray(runs.size)
        states = IntArray(runs.size)
        var next = 0
        for (run in runs.indices) {
            val start = runs[run]
            while (next < starts.size && starts[next] <= start) next++
            from[run] = x[start]
            to[run] = when {
                next == starts.size -> maxOf(end, x[start])

                // Where x jumps back, the state is known until the last sample before the jump.
                x[starts[next]] < x[start] -> x[starts[next] - 1]

                else -> x[starts[next]]
            }
            states[run] = y[start].toInt()
        }
    }

    /** Whether the runs are in the order of x. */
    public val isOrdered: Boolean = series.isOrdered

    private val ends = if (isOrdered) Series(to, to) else null

    private val times: DoubleArray by lazy {
        val sums = DoubleArray((states.maxOrNull() ?: -1) + 1)
        for (i in states.indices) sums[states[i]] += to[i] - from[i]
        sums
    }

    /** Returns the total length of the runs in [state], in the unit of x. */
    public fun timeIn(state: Int): Double = times[state]

    /** Returns the index of the first run that may extend to [position] or beyond. */
    public fun firstReaching(position: Double): Int = ends?.firstAtOrAfter(position) ?: 0

    private fun isSame(one: Double, other: Double) = one == other || (one.isNaN() && other.isNaN())
}
