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

/** What `plan distance` is: how far the robot is from where its plan has it, in meters. */
internal val DEVIATION = Signal(RuleProgram.PLAN_DISTANCE, SignalKind.NUMBER, "m")

/** The samples of [DEVIATION] in [view], of whose topics [log] has those; none without a plan. */
internal fun planDistanceIn(view: LogView, log: Signals): Series {
    val path = PlannedPath.of(posesOf(view.recording.topics)) ?: return Series(DoubleArray(0), DoubleArray(0))
    val driven = trailOf(log.series(path.driven.x), log.series(path.driven.y), path.driven.meters)
    val planned = trailOf(log.series(path.planned.x), log.series(path.planned.y), path.planned.meters)
    return planDistance(driven, planned, planSpans(view))
}
