package badlog.rules

import badlog.analysis.LogView
import badlog.analysis.Series
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.rules.path.PlannedPath
import badlog.rules.path.planDistance
import badlog.rules.path.planSpans
import badlog.rules.path.posesOf
import badlog.rules.path.trailOf

/** The signal `plan distance`: the distance of the robot from its planned place, in meters. */
internal val DEVIATION = Signal(RuleProgram.PLAN_DISTANCE, SignalKind.NUMBER, "m")

/** Returns the samples of [DEVIATION] in [view], whose topics' samples are in [log]; none if there is no plan. */
internal fun planDistanceIn(view: LogView, log: Signals): Series {
    val path = PlannedPath.of(posesOf(view.recording.topics)) ?: return Series(DoubleArray(0), DoubleArray(0))
    val driven = trailOf(log.series(path.driven.x), log.series(path.driven.y), path.driven.meters)
    val planned = trailOf(log.series(path.planned.x), log.series(path.planned.y), path.planned.meters)
    return planDistance(driven, planned, planSpans(view))
}
