package badlog.viewer.shown.statistics

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.text.exactText
import badlog.viewer.text.lengthText
import badlog.viewer.text.numberText
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.round
import kotlin.math.sqrt

/**
 * The difference between two lines of a graph.
 *
 * @property one the first line.
 * @property other the line that is subtracted from it.
 * @param width the length of the examined part of x.
 */
class NamedDifference(val one: GraphSeries, val other: GraphSeries, private val difference: LineDifference, private val width: Double) {
    /** Returns the displayed values, in the order of [TITLES]; [offset] is added to the place. */
    fun texts(axis: XAxis, offset: Double = 0.0): List<String> = with(difference) {
        listOf(
            withUnit(numberText(mean), one.unit),
            withUnit(numberText(rms), one.unit),
            withUnit(numberText(largest), one.unit),
            withUnit(placeText(largestAt + offset, axis, width), axis.unit),
            lag?.let { "${lengthText(abs(it), axis)} ${if (it >= 0) "behind" else "ahead"}" } ?: "–",
        )
    }

    /** Returns the values to the last digit, without units; [offset] is added to the place. */
    fun exactTexts(offset: Double = 0.0): List<String> = with(difference) {
        listOf(exactText(mean), exactText(rms), exactText(largest), exactText(largestAt + offset), lag?.let(::exactText) ?: "–")
    }

    companion object {
        /** The titles of the [texts]. */
        val TITLES: List<String> = listOf("mean", "RMS", "largest", "at", "lag")

        /** The meanings of the titles, one sentence each. */
        val HINTS: List<String> = listOf(
            "the mean difference by time",
            "the root mean square of the difference: the usual measure of how well something follows",
            "the difference that is farthest from 0",
            "where the largest difference is",
            "how far the line is behind the other, if shifting it makes them fit much better",
        )

        /** The maximum number of differences that a graph shows. */
        const val MAX_SHOWN: Int = 6

        /**
         * Returns the differences of a graph's [lines] within [parts] of x, at most [MAX_SHOWN]. Each is between a line and the first one
         * of its unit.
         */
        fun of(lines: List<GraphSeries>, parts: List<Span>): List<NamedDifference> {
            val width = parts.sumOf { it.width }
            fun endOf(line: GraphSeries) = line.holdsUntil ?: line.data.range?.endInclusive ?: Double.NaN
            val pairs = lines.filter {
                it.states == null
            }.groupBy { it.unit }.values.flatMap { alike -> alike.drop(1).map { it to alike[0] } }
            return pairs.take(MAX_SHOWN).mapNotNull { (line, first) ->
                differenceOf(line.data, first.data, parts, first.unit, endOf(line), endOf(first))?.let {
                    NamedDifference(line, first, it, width)
                }
            }
        }
    }
}

/**
 * The difference between two lines by time: each difference counts as long as it holds.
 *
 * @property mean the mean difference, the first line minus the second.
 * @property rms the root mean square of the difference: the usual measure of how well something follows its target.
 * @property largest the difference that is farthest from 0.
 * @property largestAt the x of that difference.
 * @property lag the delay of the first line behind the second on x, negative if it is ahead; null if no shift makes them fit much better.
 */
class LineDifference(val mean: Double, val rms: Double, val largest: Double, val largestAt: Double, val lag: Double?)

/**
 * Returns the difference between [one] and [other] within [parts] of x. Null if they have no samples in common, or x goes backwards. Each
 * sample holds until the next one of its line, and the last one until [endOfOne] or [endOfOther].
 *
 * @param unit the unit of both. If one of them wraps around from one end of a turn to the other, the shorter way around counts.
 */
fun differenceOf(
    one: Series,
    other: Series,
    parts: List<Span>,
    unit: String,
    endOfOne: Double = one.range?.endInclusive ?: Double.NaN,
    endOfOther: Double = other.range?.endInclusive ?: Double.NaN,
): LineDifference? {
    if (!one.isOrdered || !other.isOrdered) return null
    val until = minOf(endOfOne, endOfOther)
    val known = parts.map { Span(it.from, minOf(it.to, until)) }.filter { it.from < it.to }
    if (known.isEmpty()) return null
    val turn = turnOf(unit, one, other)
    var time = 0.0
    var sum = 0.0
    var squares = 0.0
    var largest = 0.0
    var largestAt = Double.NaN
    for (part in known) {
        forEachDifference(one, other, part, turn) { from, to, difference ->
            time += to - from
            sum += (to - from) * difference
            squares += (to - from) * difference * difference
            if (largestAt.isNaN() || abs(difference) > abs(largest)) {
                largest = difference
                largestAt = from
            }
        }
    }
    if (!(time > 0)) return null
    return LineDifference(sum / time, sqrt(squares / time), largest, largestAt, lagOf(one, other, known.maxBy { it.width }, turn))
}

/** Calls [each] with every stretch within [part] in which neither line changes and both have a value. */
private inline fun forEachDifference(
    one: Series,
    other: Series,
    part: Span,
    turn: Double,
    each: (from: Double, to: Double, difference: Double) -> Unit,
) {
    if (one.size == 0 || other.size == 0) return
    var i = one.firstAfter(part.from) - 1
    var k = other.firstAfter(part.from) - 1
    var from = part.from
    while (from < part.to) {
        val next = minOf(one.x.getOrElse(i + 1) { part.to }, other.x.getOrElse(k + 1) { part.to }, part.to)
        if (i >= 0 && k >= 0 && next > from) {
            val difference = wrapped(one.y[i] - other.y[k], turn)
            if (difference.isFinite()) each(from, next, difference)
        }
        while (i + 1 < one.size && one.x[i + 1] <= next) i++
        while (k + 1 < other.size && other.x[k + 1] <= next) k++
        from = next
    }
}

/**
 * Returns the shift at which the lines fit best, at most a tenth of [part], sampled at equal distances. Null if the shift does not halve
 * the mean square of the difference, or if the best shift is the largest.
 */
private fun lagOf(one: Series, other: Series, part: Span, turn: Double): Double? {
    val step = part.width / SAMPLES
    if (!(step > 0)) return null
    val first = sampled(one, part, step)
    val second = sampled(other, part, step)

    /** Returns the mean square of the difference if the first line is [shift] samples behind. */
    fun squareAt(shift: Int): Double {
        var sum = 0.0
        var count = 0
        for (i in MAX_SHIFT until SAMPLES - MAX_SHIFT) {
            val difference = wrapped(first[i] - second[i - shift], turn)
            if (difference.isNaN()) continue
            sum += difference * difference
            count++
        }
        return if (count < SAMPLES / 2) Double.NaN else sum / count
    }
    val squares = DoubleArray(2 * MAX_SHIFT + 1) { squareAt(it - MAX_SHIFT) }
    if (squares.any { it.isNaN() }) return null
    val best = squares.indices.minBy { squares[it] }
    if (best == MAX_SHIFT || best == 0 || best == squares.lastIndex || squares[best] > squares[MAX_SHIFT] * MUCH_BETTER) return null
    val (before, at, after) = listOf(squares[best - 1], squares[best], squares[best + 1])
    // The vertex of the parabola through the three values.
    val bend = before - 2 * at + after
    val fine = if (bend > 0) (before - after) / (2 * bend) else 0.0
    return (best - MAX_SHIFT + fine) * step
}

private fun sampled(series: Series, part: Span, step: Double): DoubleArray {
    var next = series.firstAfter(part.from)
    return DoubleArray(SAMPLES) { i ->
        val x = part.from + i * step
        while (next < series.size && series.x[next] <= x) next++
        if (next == 0) Double.NaN else series.y[next - 1]
    }
}

private fun wrapped(difference: Double, turn: Double) = if (turn.isNaN()) difference else difference - turn * round(difference / turn)

/** Returns a full turn in [unit]; NaN if that is not a unit of angles, or neither line wraps around. */
private fun turnOf(unit: String, one: Series, other: Series): Double {
    val turn = when (unit.trim().lowercase()) {
        "deg", "degree", "degrees", "°" -> DEGREES
        "rad", "radian", "radians" -> 2 * PI
        "rot", "rotation", "rotations", "turn", "turns", "rev", "revolutions" -> 1.0
        else -> return Double.NaN
    }
    return if (wraps(one, turn) || wraps(other, turn)) turn else Double.NaN
}

/** Returns whether [series] wraps around. If so, it stays within one [turn], and jumps by about that from one end to the other. */
private fun wraps(series: Series, turn: Double): Boolean {
    var least = Double.POSITIVE_INFINITY
    var most = Double.NEGATIVE_INFINITY
    var jumps = false
    for (i in 0 until series.size) {
        val y = series.y[i]
        if (y < least) least = y
        if (y > most) most = y
        if (i > 0 && abs(abs(y - series.y[i - 1]) - turn) < turn * JUMP) jumps = true
    }
    return jumps && most - least <= turn * ROUNDED
}

private const val DEGREES = 360.0

/** The maximum movement of a line during the jump, as a fraction of the turn. */
private const val JUMP = 0.2

/** The largest range of an angle within a turn, as a fraction of the turn, with a tolerance for rounding. */
private const val ROUNDED = 1.05
private const val SAMPLES = 1000
private const val MAX_SHIFT = 100
private const val MUCH_BETTER = 0.5
