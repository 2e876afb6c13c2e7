package badlog.signals.pose

import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsAutonomous
import badlog.core.analysis.knowsEnabled
import kotlin.math.round
import kotlin.math.sqrt

/** The distance from its planned place, in meters, below which a robot is on its plan. */
const val PLAN_LIMIT: Double = 0.5

/** The number of seconds for which a robot may be further away without having left its plan. */
const val PLAN_PATIENCE: Double = 0.3

/**
 * Returns the spans in which the robot of [view] follows plans: autonomous. If that is not known, returns the spans in which it is enabled;
 * if those are not known either, all the time.
 */
fun planSpans(view: LogView): List<Span> {
    if (!view.knowsEnabled) return listOfNotNull(view.xAxis.range?.let { Span(it.start, it.endInclusive) })
    return view.enabledSpans().filter { it.isAutonomous || !view.knowsAutonomous }.map { it.span }
}

/**
 * Returns the distance of [driven] from its planned place in [planned] at the same moment during [spans]. It is in meters, rounded to centimeters: a
 * sample for each of [driven], NaN where no plan was followed. A plan is followed
 *
 * - as long as it keeps changing: afterwards it is over;
 * - by less than [PLAN_LIMIT] from sample to sample: a larger jump is another plan, or a goal without a path to it;
 * - from the moment on at which the robot was within [PLAN_LIMIT] of it: a robot that was never on a plan has not left it.
 */
fun planDistance(driven: Trail, planned: Trail, spans: List<Span>): Series {
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

/** Returns when the plans of [planned] move within [span], each from its start until its last change. */
private fun plansIn(planned: Trail, span: Span): List<Span> {
    val found = ArrayList<Span>()
    var begin = span.from
    var end = Double.NaN
    // The last plan before the span still counts at its start.
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
