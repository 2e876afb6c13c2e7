package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns 1 at those [times] at which something that moved whenever it was driven stands still, otherwise 0. Its [places] stay the same
 * although its motor's [outputs] (1 is full) push it each way. So it does not rest at a stop: it is blocked, or its sensor is dead. The
 * direction in which it is driven does not matter.
 *
 * Earlier pushes must have moved it consistently; otherwise places and outputs belong to different mechanisms. If few pushes did, or if it
 * is near an end of its range, it must stand still for longer. If the place then jumps, it was only not read meanwhile, and does not count.
 */
fun standstill(times: DoubleArray, places: DoubleArray, outputs: DoubleArray, isEnabled: BooleanArray): Series {
    val used = DoubleArray(times.size) { if (isEnabled[it]) places[it] else Double.NaN }
    val low = quantile(used, 0.01)
    val range = quantile(used, 0.99) - low
    val still = DoubleArray(times.size)
    if (!(range > 0)) return Series(times, still)
    fun way(at: Int) = if (isEnabled[at] && abs(outputs[at]) > PUSHED) sign(outputs[at]) else 0.0
    var moves = 0
    val run = StillRun(times, places, STILL * range)
    var i = 0
    while (i < times.size) {
        val way = way(i)
        var end = i + 1
        while (end < times.size && way(end) == way) end++
        val seconds = times[minOf(end, times.size - 1)] - times[i]
        if (way != 0.0 && seconds >= PUSH_SECONDS) {
            if (run.takes(i, end, way, seconds, still)) {
                val moved = abs(moves)
                val share = (places[i] - low) / range
                val isAtEnd = share < END || share > 1 - END
                if (run.isLongEnough(if (isAtEnd) minOf(moved, MIN_MOVED - 1) else moved) && run.stood <= moved * MAX_STOOD) run.mark(still)
            } else {
                val step = (places[end - 1] - places[i]) / range
                if (abs(step) > MOVED) moves += sign(step * way).toInt()
            }
        }
        i = end
    }
    return Series(times, still)
}

/** Returns [outputs] while [current] flows, otherwise 0: a motor without power pushes nothing. A current that is always 0 was never read. */
internal fun powered(outputs: DoubleArray, current: DoubleArray): DoubleArray {
    val least = 0.1 * quantile(DoubleArray(current.size) { abs(current[it]) }, 0.98)
    return DoubleArray(outputs.size) { if (abs(current[it]) < least) 0.0 else outputs[it] }
}

/** The pushes during which something has not moved since the last that moved it by more than [most]. */
private class StillRun(private val times: DoubleArray, private val places: DoubleArray, private val most: Double) {
    /** The pushes that did not move it, in runs that ended before they showed anything. */
    var stood = 0
        private set
    private val pushes = ArrayList<IntRange>()
    private var isMarked = false
    private var up = 0.0
    private var down = 0.0

    /** Returns whether it was pushed long enough each way for something that [moved] pushes had moved before. */
    fun isLongEnough(moved: Int): Boolean {
        val eachWay = minOf(up, down)
        val isLong = eachWay >= LONG_SECONDS && pushes.size >= MANY_PUSHES
        return if (moved >= MIN_MOVED) eachWay >= EACH_WAY_SECONDS else moved >= FEW_MOVED && isLong
    }

    /** Adds the push from [from] until [until]. False if it moved something, which ends the run and its mark in [still] if it jumped. */
    fun takes(from: Int, until: Int, way: Double, seconds: Double, still: DoubleArray): Boolean {
        val start = pushes.firstOrNull()?.first ?: from
        val moved = (start until until).firstOrNull { !(abs(places[it] - places[start]) <= most) }
        if (moved != null) {
            if (!isMarked) stood += pushes.size
            val jump = abs(places[moved] - places[maxOf(moved - 1, 0)])
            if (isMarked && jump > JUMP * most) for (push in pushes) still.fill(0.0, push.first, push.last + 1)
            pushes.clear()
            isMarked = false
            up = 0.0
            down = 0.0
            return false
        }
        pushes += from until until
        if (way > 0) up += seconds else down += seconds
        return true
    }

    fun mark(still: DoubleArray) {
        isMarked = true
        for (push in pushes) for (at in push) still[at] = 1.0
    }
}

/** More than holds most things up. */
private const val PUSHED = 0.25
private const val PUSH_SECONDS = 0.3
private const val EACH_WAY_SECONDS = 2.0

/** Of its range: more than play between gears. */
private const val STILL = 0.005
private const val MOVED = 0.05
private const val END = 0.03

/** As many times [STILL]. */
private const val JUMP = 40

/** The number of pushes that must have moved it the same way before. Then the share of those that may not have moved it. */
private const val MIN_MOVED = 8
private const val MAX_STOOD = 0.15

/** Fewer pushes that moved it are enough if it stood still for longer. */
private const val FEW_MOVED = 4
private const val LONG_SECONDS = 5.0
private const val MANY_PUSHES = 4
