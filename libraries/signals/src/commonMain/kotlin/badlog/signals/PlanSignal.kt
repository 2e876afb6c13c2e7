package badlog.signals

import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.signals.pose.PlannedPath
import badlog.signals.pose.planDistance
import badlog.signals.pose.planSpans
import badlog.signals.pose.posesOf
import badlog.signals.pose.trailOf

/** The name of the signal [DEVIATION]. */
const val PLAN_DISTANCE = "plan distance"

/** The signal `plan distance`: the distance of the robot from its planned place, in meters. */
val DEVIATION = Signal(PLAN_DISTANCE, SignalKind.NUMBER, "m")

/** Returns the samples of [DEVIATION] in [view], with its topics in [log]; none if no topic is a plan. */
fun planDistanceIn(view: LogView, log: Signals): Series {
    val path = PlannedPath.of(posesOf(view.recording.topics)) ?: return Series(DoubleArray(0), DoubleArray(0))
    val driven = trailOf(log.series(path.driven.x), log.series(path.driven.y), path.driven.meters)
    val planned = trailOf(log.series(path.planned.x), log.series(path.planned.y), path.planned.meters)
    return planDistance(driven, planned, planSpans(view))
}
