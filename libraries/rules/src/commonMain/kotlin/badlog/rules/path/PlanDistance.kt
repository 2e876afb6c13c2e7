package badlog.rules.path

import badlog.analysis.LogView
import badlog.analysis.Series
import badlog.analysis.Span
import badlog.analysis.enabledSpans
import badlog.analysis.knowsAutonomous
import badlog.analysis.knowsEnabled
import kotlin.math.round
import kotlin.math.sqrt

/** Who is nearer than this to where the plan has it is on it, in meters. */
public const val PLAN_LIMIT: Double = 0.5

/** So many seconds a robot may be further away and has not left its plan. */
public const val PLAN_PATIENCE: Double = 0.3

/** When the robot of [view] follows plans: while it drives by itself, or is enabled where that is not known, or all the time. */
public fun planSpans(view: LogView): List<Span> {
    if (!view.knowsEnabled) return listOfNotNull(view.xAxis.range?.let { Span(it.start, it.endInclusive) })
    return view.enabledSpans().filter { it.isAutonomous || !view.knowsAutonomous }.map { it.span }
}

/**
 * How far [driven] was from where [planned] had it at the same moment during [spans], in meters, in whole centimeters: a sample for each of
 * [driven], NaN where no plan was followed. One is followed
 *
 * - as long as it goes on changing: afterwards nobody follows it;
 * - by less than [PLAN_LIMIT] from sample to sample: what jumps further is another plan, or a goal without a way to it;
 * - from the moment on at which the robot was within [PLAN_LIMIT] of it: who was never on a plan has not left it.
 */
public fun planDistance(driven: Trail, planned: Trail, spans: List<Span>): Series {
    val distances = DoubleArray(driven.size) { Double.NaN }
    for (span in spans) {
        for (plan in plansIn(planned, span)) {
            var isFollowed = false
            for (i in driven.startOf(plan) until driven.endOf(plan)) {
                val at = planned.indexAt(driven.times[i])
                if (at < 0 || !planned.isPlace(at) || !driven.isPlace(i)) continue
                val distance = round(distance(driven, i, planned, at) * CENTIMETERS) / CENTIMETERS
                if (distance <= PLAN_LIMIT) isFollowed = true
                if (isFollowed) distances[i] = distance
            }
        }
    }
    return Series(driven.times, distances)
}

/** When in [span] the plans of [planned] move, from where each begins until its last move. */
private fun plansIn(planned: Trail, span: Span): List<Span> {
    val found = ArrayList<Span>()
    var begin = span.from
    var end = Double.NaN
    // What was planned last before the span still counts when it begins.
    var last = planned.indexAt(span.from)
    fun finish() {
        if (!end.isNaN()) found += Span(begin, end)
    }
    for (i in maxOf(last, 0) until planned.endOf(span)) {
        if (!planned.isPlace(i)) continue
        val step = if (last < 0 || !planned.isPlace(last)) 0.0 else distance(planned, i, planned, last)
        last = i
        if (step >= PLAN_LIMIT) {
            finish()
            begin = planned.times[i]
            end = Double.NaN
        } else if (step > 0) {
            end = planned.times[i]
        }
    }
    finish()
    return found
}

private fun distance(one: Trail, at: Int, other: Trail, otherAt: Int): Double {
    val right = one.x[at] - other.x[otherAt]
    val up = one.y[at] - other.y[otherAt]
    return sqrt(right * right + up * up)
}

private const val CENTIMETERS = 100
