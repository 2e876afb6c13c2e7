package badlog.signals.derived

import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns how much more output one side of a tank drive needs than the other at the same speed. It is a fraction of full output: the
 * remainder after the output for speed and acceleration, both fitted to the log. Positive if the first side needs more. Null if there is
 * too little straight driving to tell. All arrays have the same times.
 */
fun sideFriction(times: DoubleArray, one: Side, other: Side): Double? {
    val top = quantile(DoubleArray(times.size) { abs(one.speed[it]) }, 0.98)
    // In turns, wheels scrub.
    val isStraight = BooleanArray(times.size) { abs(one.speed[it] - other.speed[it]) < 0.1 * top }
    val first = frictionOf(times, one, isStraight) ?: return null
    val second = frictionOf(times, other, isStraight) ?: return null
    return first - second
}

/** Output (-1 to 1) and speed of a side of a tank drive. */
class Side(val output: DoubleArray, val speed: DoubleArray)

/**
 * Returns the current that corresponds to full output, from the [currents] of the motors. At its limit, a motor takes about a quarter of
 * it.
 */
internal fun fullCurrentOf(currents: List<DoubleArray>): Double = 4 * currents.maxOf { own ->
    // Short peaks do not count.
    quantile(DoubleArray(own.size) { abs(own[it]) }, 0.99).coerceAtLeast(1.0)
}

/** Returns the output that friction takes. The constant part of output over speed and acceleration, in the direction of the speed. */
private fun frictionOf(times: DoubleArray, side: Side, isStraight: BooleanArray): Double? {
    val top = quantile(DoubleArray(times.size) { abs(side.speed[it]) }, 0.98)
    if (!(top > 0)) return null
    val sums = Array(3) { DoubleArray(4) }
    var count = 0
    for (i in 2 until times.size - 2) {
        val speed = side.speed[i]
        if (!isStraight[i] || !(abs(speed) > 0.1 * top) || !side.output[i].isFinite()) continue
        // A device that sends nothing leaves its last values.
        if (side.speed[i] == side.speed[i - 1] && side.speed[i] == side.speed[i - 2] && side.output[i] == side.output[i - 2]) continue
        val seconds = times[i + 2] - times[i - 2]
        if (seconds <= 0 || seconds > 0.3) continue
        val forward = sign(speed)
        val row = doubleArrayOf(1.0, abs(speed) / top, (side.speed[i + 2] - side.speed[i - 2]) / seconds * forward / top)
        val value = side.output[i] * forward
        for (a in 0..2) {
            for (b in 0..2) sums[a][b] += row[a] * row[b]
            sums[a][3] += row[a] * value
        }
        count++
    }
    return if (count < 300) null else solved(sums)?.get(0)
}

/**
 * Returns the solution of a system of linear equations; the last column of [rows] is the right-hand side. Null if it has none. Changes
 * [rows].
 */
internal fun solved(rows: Array<DoubleArray>): DoubleArray? {
    val n = rows.size
    for (k in 0 until n) {
        val pivot = (k until n).maxByOrNull { abs(rows[it][k]) } ?: return null
        if (abs(rows[pivot][k]) < 1e-12) return null
        rows[k] = rows[pivot].also { rows[pivot] = rows[k] }
        for (i in 0 until n) {
            if (i == k) continue
            val factor = rows[i][k] / rows[k][k]
            for (j in k..n) rows[i][j] -= factor * rows[k][j]
        }
    }
    return DoubleArray(n) { rows[it][n] / rows[it][it] }
}
