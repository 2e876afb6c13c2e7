package badlog.signals.derived

import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns the rise of a mechanism's friction in a log. It compares the efforts for the same movements, in both directions, in the last two
 * fifths of enabled time and in the first sixth. The rise is a fraction of the highest effort at first, without the part that depends on
 * speed; 0 for a healthy mechanism. The weight that it lifts does not count, since it helps on the way down. Null if it moved too little to
 * tell.
 *
 * All arrays have the same times: its [place], and the [effort] of its motor, such as its current or the voltage that it gets.
 */
fun frictionRise(times: DoubleArray, place: DoubleArray, effort: DoubleArray, isEnabled: BooleanArray): Double? {
    val used = times.indices.filter { isEnabled[it] }
    if (used.isEmpty()) return null
    val start = times[used.first()]
    val seconds = times[used.last()] - start
    if (seconds < MIN_SECONDS) return null
    val speed = speedsOf(times, place)
    val top = quantile(DoubleArray(times.size) { if (isEnabled[it]) abs(speed[it]) else Double.NaN }, 0.98)
    if (!(top > 0)) return null
    val strokes = Strokes(times, speed, effort, top)
    for (i in used) {
        val at = times[i] - start
        if (at < seconds * EARLY) {
            strokes.add(i, 0)
        } else if (at > seconds * LATE) {
            strokes.add(i, 1)
        }
    }
    return strokes.rise()
}

/** Returns whether the sign of [amperes], which a motor draws, shows which way it pushes; some controllers report only magnitudes. */
internal fun hasDirection(amperes: DoubleArray): Boolean = quantile(amperes, 0.01) < -0.05 * quantile(amperes, 0.99)

/** The samples in which a mechanism moves, at first and later, and the fit of its effort. */
private class Strokes(
    private val times: DoubleArray,
    private val speed: DoubleArray,
    private val effort: DoubleArray,
    private val top: Double,
) {
    private val rows = ArrayList<DoubleArray>()
    private val values = ArrayList<Double>()
    private val counts = IntArray(4)

    fun add(i: Int, part: Int) {
        if (i < 2 || i + 2 >= times.size || !(abs(speed[i]) > MOVING * top) || !effort[i].isFinite()) return
        val span = times[i + 2] - times[i - 2]
        if (span <= 0 || span > LONGEST_SPAN || !speed[i + 2].isFinite() || !speed[i - 2].isFinite()) return
        val way = sign(speed[i])
        val row = DoubleArray(PARAMETERS)
        row[part] = 1.0
        row[2 + part] = way
        row[4] = speed[i] / top
        row[5] = (speed[i + 2] - speed[i - 2]) / span / top
        rows += row
        values += effort[i]
        counts[2 * part + if (way > 0) 1 else 0]++
    }

    fun rise(): Double? {
        if (counts.any { it < MIN_SAMPLES }) return null
        val sums = Array(PARAMETERS) { DoubleArray(PARAMETERS + 1) }
        for ((row, value) in rows.zip(values)) {
            for (a in 0 until PARAMETERS) {
                if (row[a] == 0.0) continue
                for (b in 0 until PARAMETERS) sums[a][b] += row[a] * row[b]
                sums[a][PARAMETERS] += row[a] * value
            }
        }
        val fit = solved(sums) ?: return null
        val needed = quantile(DoubleArray(rows.size) { if (rows[it][0] > 0) abs(values[it] - fit[4] * rows[it][4]) else Double.NaN }, 0.98)
        return if (needed > 0) (fit[3] - fit[2]) / needed else null
    }
}

/** Returns the speed at each of [times], from the places around it. */
private fun speedsOf(times: DoubleArray, place: DoubleArray) = DoubleArray(times.size) { i ->
    val before = maxOf(0, i - 2)
    val after = minOf(times.lastIndex, i + 2)
    val span = times[after] - times[before]
    if (span > 0 && span < LONGEST_SPAN) (place[after] - place[before]) / span else Double.NaN
}

private const val MIN_SECONDS = 30.0
private const val EARLY = 1.0 / 6
private const val LATE = 0.6
private const val MOVING = 0.2
private const val LONGEST_SPAN = 0.3
private const val MIN_SAMPLES = 12
private const val PARAMETERS = 6
