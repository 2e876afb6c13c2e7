package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs

/**
 * Returns 1 while [measured] keeps exactly a value to which it jumped faster than it usually moves, otherwise 0. An absolute encoder
 * without a cable reads like that. A jump does not count if the value hardly moved before, since it was at rest. Nor does the end of a fast
 * movement, since it has arrived at a stop, nor a jump back, after a misread value or of an angle at the end of its turn. It counts once one
 * of [outputs] is not 0 afterwards: code sets a position at a switch, and stops the motor there.
 */
fun deadReading(times: DoubleArray, measured: DoubleArray, isEnabled: BooleanArray, outputs: List<Series> = emptyList()): Series {
    val range = rangeOf(measured)
    fun step(at: Int) = abs(measured[at] - measured[at - 1])
    val speeds = DoubleArray(times.size) { i -> if (i == 0 || times[i] == times[i - 1]) 0.0 else step(i) / (times[i] - times[i - 1]) }
    val usual = quantile(DoubleArray(times.size) { if (speeds[it] > 0) speeds[it] else Double.NaN }, 0.98)
    fun isArrival(at: Int) = at > 1 && speeds[at - 1] > usual && (measured[at] > measured[at - 1]) == (measured[at - 1] > measured[at - 2])
    var isDead = false
    var isDriven = false
    var jumped = Double.NaN
    var before = Double.NaN
    var movedSeconds = 0
    var lastMoved = -1L
    return Series(
        times,
        DoubleArray(times.size) { i ->
            if (i > 0 && measured[i] != measured[i - 1]) {
                isDead = movedSeconds >= MIN_MOVED && step(i) > JUMP * range && speeds[i] > FASTER * usual && !isArrival(i) &&
                    !(abs(measured[i] - before) < JUMP * range)
                isDriven = outputs.isEmpty()
                jumped = times[i]
                before = measured[i - 1]
                if (times[i].toLong() != lastMoved) movedSeconds++
                lastMoved = times[i].toLong()
            }
            if (isDead &&
                !isDriven
            ) {
                isDriven = outputs.any { it.isUsed(maxOf(times[i], jumped + LATE_SECONDS), times.getOrElse(i + 1) { times[i] }) }
            }
            if (isDead && isDriven && isEnabled[i]) 1.0 else 0.0
        },
    )
}

/** Returns whether this is ever not 0 from [from] until [to]. Its values hold. */
private fun Series.isUsed(from: Double, to: Double) = (maxOf(firstAfter(from) - 1, 0) until firstAfter(to)).any { y[it] != 0.0 }

private const val JUMP = 0.1
private const val FASTER = 2.5

/** A motor stops within this time after its position was set, in s. */
private const val LATE_SECONDS = 0.1

/** The number of seconds in which it must have moved before. */
private const val MIN_MOVED = 5
