package badlog.signals.derived

import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The roles of motors that are known by their ids alone, found by their speeds. Motors on one shaft turn in a fixed ratio; the first of
 * them represents all.
 *
 * @param speeds the speed of each motor, at the same times.
 * @param places the position of each motor at these times; empty if it is not reported.
 * @param isEncoded whether each has an absolute encoder of its own, as steering motors have.
 */
class BusRoles(private val speeds: List<DoubleArray>, private val places: List<DoubleArray>, isEncoded: List<Boolean>) {
    private val sizes = speeds.map { own -> DoubleArray(own.size) { abs(own[it]) } }
    private val tops = sizes.map { quantile(it, 0.98) }

    /** The motors that are alone on their shaft, or the first on it. */
    val leaders: List<Int> = speeds.indices.filter { at -> (0 until at).none { isOnShaft(it, at) } }

    /** The drive motors of a robot: four of a swerve drive, two of a tank drive. Empty if that is not known. */
    val drive: List<Int>

    /** The motors that turn the modules of a swerve drive; not all if some are unknown. */
    val steering: List<Int>

    /** The motors that move mechanisms; empty unless [drive] is known, since a drive motor that stalls is not a jammed mechanism. */
    val mechanisms: List<Int>

    init {
        val free = leaders.filter { !isEncoded[it] && tops[it] > 0 }
        val modules = alike(free, 4)
        // Two rollers run alike, too, but never against each other, as the sides of a turning robot do. Each side has several motors.
        drive = modules ?: alike(free.filter(::isFollowed), 2)?.takeIf { (one, other) -> turnsAgainst(one, other) } ?: emptyList()
        val encoded = isEncoded.indices.filter { isEncoded[it] }
        steering = alike(leaders.filter { it !in drive && tops[it] > 0 }, 4).takeIf { modules != null }.orEmpty() +
            if (encoded.size > 2) encoded else emptyList()
        mechanisms = if (drive.isEmpty()) emptyList() else leaders.filter { it !in drive && it !in steering }
    }

    private fun isFollowed(at: Int) = speeds.indices.any { it > at && isOnShaft(at, it) }

    // Frames of two devices come at different times, which matters less for places.
    private fun isOnShaft(one: Int, other: Int): Boolean = abs(correlation(speeds[one], speeds[other])) > SAME_SPEED ||
        (places[one].size == places[other].size && abs(correlation(places[one], places[other])) > SAME_PLACE)

    /** Returns the [count] motors among [motors] that run alike; of several such sets, the one that turned most. Null if there is none. */
    private fun alike(motors: List<Int>, count: Int): List<Int>? = motors.map { one -> motors.filter { it == one || isAlike(one, it) } }
        .filter { set -> set.size == count && set.all { one -> set.all { it == one || isAlike(one, it) } } }
        .maxByOrNull { set -> set.sumOf { sizes[it].sumOf { size -> if (size.isFinite()) size else 0.0 } } }

    private fun isAlike(one: Int, other: Int): Boolean =
        tops[one] < 1.5 * tops[other] && tops[other] < 1.5 * tops[one] && correlation(sizes[one], sizes[other]) > ALIKE

    private fun turnsAgainst(one: Int, other: Int): Boolean {
        val moving = speeds[one].indices.filter { minOf(sizes[one][it] / tops[one], sizes[other][it] / tops[other]) > MOVING }
        val against = moving.count { speeds[one][it] * speeds[other][it] < 0 }
        val back = moving.count { speeds[one][it] < 0 }
        // A driver who hardly turns on the spot drives back and forth.
        val turns = if (minOf(back, moving.size - back) > OFTEN * moving.size) RARE_TURNS else TURNS
        return minOf(against, moving.size - against, back, moving.size - back) > turns * moving.size
    }
}

/** Returns the correlation of [one] and [other], -1 to 1, where both are finite. 0 if one of them is constant. */
fun correlation(one: DoubleArray, other: DoubleArray, from: Int = 0, until: Int = one.size): Double {
    var n = 0
    var meanA = 0.0
    var meanB = 0.0
    var squaresA = 0.0
    var squaresB = 0.0
    var products = 0.0
    for (i in from until until) {
        if (!one[i].isFinite() || !other[i].isFinite()) continue
        n++
        val a = one[i] - meanA
        val b = other[i] - meanB
        meanA += a / n
        meanB += b / n
        squaresA += a * (one[i] - meanA)
        squaresB += b * (other[i] - meanB)
        products += a * (other[i] - meanB)
    }
    return if (squaresA > 0 && squaresB > 0) products / sqrt(squaresA * squaresB) else 0.0
}

private const val SAME_SPEED = 0.9997
private const val SAME_PLACE = 0.9997
private const val ALIKE = 0.6
private const val MOVING = 0.04
private const val TURNS = 0.004
private const val RARE_TURNS = 0.001
private const val OFTEN = 0.2
